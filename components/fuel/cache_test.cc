#include "fuel/cache.hh"

#include <gtest/gtest.h>

#include "fuel/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::fuel {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
 protected:
  test::TempFolder folder_;
  const FuelAddress address_ = *parseFuelAddress("https://h/1.0/O/models/A Model/2");
};

TEST_F(Cache, IsLockedForOneAtATime) {
  const fs::path file = folder_.path() / "lock";
  Lock first(file);
  EXPECT_TRUE(first.tryTake());
  {
    Lock second(file);
    EXPECT_FALSE(second.tryTake());
  }
  // a process that did not get the lock must not remove its file
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(Cache, LeavesNoLockAndTakesNoOldOne) {
  const fs::path file = folder_.path() / "lock";
  auto first = std::make_unique<Lock>(file);
  EXPECT_TRUE(first->tryTake());
  Lock second(file);
  first.reset();
  EXPECT_FALSE(fs::exists(file));
  // the file opened by `second` was removed by `first`: `second` creates a new one, which excludes others
  EXPECT_TRUE(second.tryTake());
  EXPECT_TRUE(fs::exists(file));
  Lock third(file);
  EXPECT_FALSE(third.tryTake());
}

TEST_F(Cache, HasItsWorkAside) {
  const Workplace workplace(address_, folder_.path());
  EXPECT_EQ(workplace.zip, folder_.path() / ".pongsim/h+o+models+a model.zip");
  FuelAddress longer = address_;
  longer.name = std::string(250, 'x');
  EXPECT_LT(Workplace(longer, folder_.path()).folder.filename().string().size(), 255U);
}

TEST_F(Cache, RemembersAPart) {
  const fs::path file = folder_.path() / "note";
  EXPECT_FALSE(PartialDownload::read(file));
  PartialDownload{3, "\"tag\"", true}.write(file);
  const std::optional<PartialDownload> partial = PartialDownload::read(file);
  ASSERT_TRUE(partial);
  EXPECT_EQ(partial->version, 3);
  EXPECT_EQ(partial->validator, "\"tag\"");
  EXPECT_TRUE(partial->isLinked);
  for (const char* text : {"", "{", "[]", "{}", "{\"version\": \"x\", \"validator\": 1, \"linked\": 2}"}) {
    folder_.write("note", text);
    EXPECT_FALSE(PartialDownload::read(file)) << text;
  }
}

TEST_F(Cache, PlacesAFolderAsAWhole) {
  folder_.write("new/a", "1");
  place(folder_.path() / "new", folder_.path() / "x/y/1");
  EXPECT_EQ(textOf(folder_.path() / "x/y/1/a"), "1");
  // an existing version is replaced
  folder_.write("new/a", "2");
  folder_.write("x/y/1/b", "");
  place(folder_.path() / "new", folder_.path() / "x/y/1");
  EXPECT_EQ(textOf(folder_.path() / "x/y/1/a"), "2");
  EXPECT_FALSE(fs::exists(folder_.path() / "x/y/1/b"));
  EXPECT_FALSE(fs::exists(folder_.path() / "new"));
  folder_.write("new/a", "3");
  folder_.write("file", "");
  EXPECT_THROW(place(folder_.path() / "new", folder_.path() / "file/1"), Failure);
}

TEST_F(Cache, TellsItsVersionsInOrder) {
  for (const char* name : {"h/o/models/m/10", "h/o/models/m/9", "h/o/models/m/x", "h/o/models/m/01", "h/o/worlds/w/1",
                           ".pongsim/a/models/b/1", "g/o/models/m/1"}) {
    folder_.write(std::string(name) + "/model.config", "");
  }
  std::string all;
  for (const CachedVersion& each : cachedVersions(folder_.path())) {
    all += each.address.url() + "/" + std::to_string(*each.address.version) + " ";
  }
  EXPECT_EQ(all,
            "https://g/1.0/o/models/m/1 https://h/1.0/o/models/m/9 https://h/1.0/o/models/m/10 "
            "https://h/1.0/o/worlds/w/1 ");
}

TEST_F(Cache, SeesWhatIsBroken) {
  const fs::path folder = folder_.path() / "m/2";
  const auto faults = [&] {
    std::string all;
    for (const std::string& fault : faultsOf({address_, folder})) all += fault + ";";
    return all;
  };
  fs::create_directories(folder);
  EXPECT_EQ(faults(), "there is no model.config in it;");
  folder_.write("m/2/model.config", "<model><!-- <sdf>a.sdf</sdf> --></model>");
  EXPECT_EQ(faults(), "its model.config has no <sdf>;");
  folder_.write("m/2/model.config", "<model><sdf version='1.9'>b.sdf</sdf></model>");
  EXPECT_EQ(faults(), "its model.config names 'b.sdf', which does not exist;");
  folder_.write("m/2/b.sdf", "");
  EXPECT_EQ(faults(), "");
  fs::create_symlink("/", folder / "root");
  EXPECT_EQ(faults(), "'root' is a link to outside it;");
  folder_.write("m/2/m.zip", "");
  EXPECT_EQ(faults(), "the zip file is still in it: Fortress is unpacking it or was interrupted;");
}

}  // namespace
}  // namespace pongsim::fuel
