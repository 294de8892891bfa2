#include "assets/finder.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

namespace fs = std::filesystem;

class FinderTest : public testing::Test {
 protected:
  /// @return The path, or the messages if none was found.
  std::string find(std::string_view uri) {
    Diagnostics diagnostics;
    const SourcePosition position{std::make_shared<const std::string>("w.sdf"), 3, 4};
    const Finder finder = finderIn({{first_.path(), second_.path()}, cache_.path()});
    const auto path = finder(uri, own_.path(), position, diagnostics);
    if (path) return diagnostics.all().empty() ? path->string() : "found, and yet an error";
    return diagnostics.all().size() == 1 ? format(diagnostics.all()[0]) : "no error, or too many";
  }

  test::TempFolder own_, first_, second_, cache_;
};

TEST_F(FinderTest, FindsAPathAsItIsAndBesideTheFile) {
  const std::string file = own_.write("a/b.sdf", "").string();
  for (const std::string& uri : {file, "file://" + file, std::string("a/b.sdf"), std::string("file://a/b.sdf")}) {
    EXPECT_EQ(find(uri), file);
  }
}

class ConfinedFinderTest : public testing::Test {
 protected:
  /// @return The path, or the message if none was found.
  std::string find(const std::string& uri, const fs::path& folder, bool isConfined = true) {
    Diagnostics diagnostics;
    Finder finder = finderIn({{models_.path()}, cache_.path()});
    if (isConfined) finder = finder.confinedTo({{models_.path()}, world_.path()});
    const auto path = finder(uri, folder, {}, diagnostics);
    return path ? path->string() : diagnostics.all().at(0).message + " " + diagnostics.all().at(0).hint;
  }
  std::string notFound(const std::string& uri) {
    const std::string said = find("/not/there", {});
    std::string same = said;
    return same.replace(same.find("/not/there"), 10, uri);
  }

  test::TempFolder world_, models_, cache_, outside_;
};

TEST_F(ConfinedFinderTest, FindsWhatIsInReach) {
  for (const test::TempFolder* folder : {&world_, &models_, &cache_}) {
    const std::string file = folder->write("a/b.stl", "").string();
    EXPECT_EQ(find(file, {}), file);
    EXPECT_EQ(find("file://" + file, {}), file);
  }
  EXPECT_EQ(find("model://a/b.stl", {}), (models_.path() / "a/b.stl").string());
  EXPECT_EQ(find("b.stl", world_.path() / "a"), (world_.path() / "a/b.stl").string());
}

TEST_F(ConfinedFinderTest, SaysTheSameOfAllElseWhetherItIsThereOrNot) {
  const fs::path secret = outside_.write("secret.stl", "");
  fs::create_symlink(secret, world_.path() / "file.stl");
  fs::create_symlink(outside_.path(), cache_.path() / "folder");
  const std::string up = "model://../" + outside_.path().filename().string() + "/secret.stl";
  for (const std::string& uri :
       {secret.string(), "file://" + secret.string(), up,
        (cache_.path() / "folder/secret.stl").string(), std::string("/dev/null")}) {
    EXPECT_EQ(find(uri, {}), notFound(uri)) << uri;
  }
  EXPECT_EQ(find("file.stl", world_.path()), notFound("file.stl"));
  EXPECT_EQ(find("secret.stl", outside_.path()), notFound("secret.stl"));
  EXPECT_EQ(find(secret.string(), world_.path(), false), secret.string());
}

// as colcon makes them in its installations
TEST_F(ConfinedFinderTest, FollowsLinksOfFoldersThatTheUserHasSet) {
  outside_.write("mesh.stl", "");
  fs::create_symlink(outside_.path(), models_.path() / "folder");
  EXPECT_EQ(find("model://folder/mesh.stl", {}), (models_.path() / "folder/mesh.stl").string());
  const std::string up = (models_.path() / "../none.stl").string();
  EXPECT_EQ(find(up, {}), notFound(up));
}

TEST_F(ConfinedFinderTest, ConfinesWhatIsInTheFuelCache) {
  const std::string secret = outside_.write("secret.stl", "").string();
  const std::string own = cache_.write("host/owner/models/m/1/m.stl", "").string();
  const fs::path folder = cache_.path() / "host/owner/models/m/1";
  EXPECT_EQ(find(secret, folder, false), notFound(secret));
  EXPECT_EQ(find("m.stl", folder, false), own);
  EXPECT_TRUE(finderIn({{}, cache_.path()}).isConfined(folder));
  EXPECT_FALSE(finderIn({{}, cache_.path()}).isConfined(world_.path()));
}

TEST_F(FinderTest, FindsAModelInTheFirstFolderThatHasIt) {
  const std::string inSecond = second_.write("sun/model.sdf", "").string();
  EXPECT_EQ(find("model://sun/model.sdf"), inSecond);
  EXPECT_EQ(find("model://sun"), (second_.path() / "sun").string());
  EXPECT_EQ(find("sun"), (second_.path() / "sun").string());
  EXPECT_EQ(find("model://sun/model.sdf"), inSecond);
  EXPECT_EQ(find("model://sun"), (second_.path() / "sun").string());
  first_.write("sun/model.sdf", "");
  EXPECT_EQ(find("model://sun"), (first_.path() / "sun").string());
}

TEST_F(FinderTest, TakesAPackageForAModel) {
  EXPECT_EQ(find("package://robot/a.stl"),
            "w.sdf:3:4: error: 'package://robot/a.stl' is not found\n  hint: looked for it at " +
                (first_.path() / "robot/a.stl").string() + ", " + (second_.path() / "robot/a.stl").string() +
                ", robot/a.stl");
  const std::string file = second_.write("robot/a.stl", "").string();
  EXPECT_EQ(find("package://robot/a.stl"), file);
}

TEST_F(FinderTest, LooksForAModelNotBesideTheFile) {
  own_.write("sun/model.sdf", "");
  EXPECT_EQ(find("sun"), (own_.path() / "sun").string());
  EXPECT_EQ(find("model://sun"), "w.sdf:3:4: error: 'model://sun' is not found\n  hint: looked for it at " +
                                     (first_.path() / "sun").string() + ", " + (second_.path() / "sun").string() +
                                     ", sun");
}

TEST_F(FinderTest, AdvisesWhereNoFolderIsNamed) {
  Diagnostics diagnostics;
  EXPECT_FALSE(finderIn({})("model://no such", "", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].hint, "looked for it at no such; set PONGSIM_RESOURCE_PATH to search more folders");
}

TEST_F(FinderTest, TakesTheVersionOfAFuelModelThatIsAskedForOrTheNewest) {
  cache_.write("fuel.gazebosim.org/openrobotics/models/coke can/2/model.config", "");
  cache_.write("fuel.gazebosim.org/openrobotics/models/coke can/3/meshes/c.dae", "");
  const fs::path model = cache_.path() / "fuel.gazebosim.org/openrobotics/models/coke can";
  const std::string address = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke Can";
  EXPECT_EQ(find(address), model / "3");
  EXPECT_EQ(find(address + "/2"), model / "2");
  EXPECT_EQ(find(address + "/tip/files/meshes/c.dae"), model / "3/meshes/c.dae");
  EXPECT_EQ(find(address + "/4"),
            "w.sdf:3:4: error: '" + address + "/4' is not in the local Fuel cache\n  hint: looked for it at " +
                (model / "4").string() + ", " +
                (cache_.path() / "fuel.ignitionrobotics.org/openrobotics/models/coke can/4").string() +
                "; download it with 'pongsim fuel download -u ADDRESS'");
  EXPECT_EQ(find(address + "/2/files/meshes/c.dae"),
            "w.sdf:3:4: error: '" + address +
                "/2/files/meshes/c.dae' is not found\n  hint: there is no 'meshes/c.dae' in " + (model / "2").string());
  // the same server by its old name
  EXPECT_EQ(find("https://fuel.ignitionrobotics.org/1.0/OpenRobotics/models/Coke Can/2"), model / "2");
}

TEST_F(FinderTest, SaysWhatIsWrongWithAnAddress) {
  EXPECT_TRUE(find("").starts_with("w.sdf:3:4: error: '' contains no name"));
  EXPECT_TRUE(find("model://").starts_with("w.sdf:3:4: error: 'model://' contains no name"));
  EXPECT_TRUE(find("ftp://x").starts_with("w.sdf:3:4: error: 'ftp://x' is not a supported kind of address"));
  EXPECT_TRUE(find("https://fuel.gazebosim.org/x")
                  .starts_with("w.sdf:3:4: error: 'https://fuel.gazebosim.org/x' is "
                               "not the address of a Fuel model or world"));
  EXPECT_TRUE(find(std::string_view("a\0b", 3)).starts_with("w.sdf:3:4: error: an address contains a zero byte"));
}

TEST_F(FinderTest, TellsOfManyPlacesTheFirst) {
  Places places;
  for (int i = 0; i < 9; ++i) places.folders.push_back("/no/" + std::to_string(i));
  Diagnostics diagnostics;
  EXPECT_FALSE(finderIn(places)("model://m", "", {}, diagnostics));
  EXPECT_EQ(diagnostics.all()[0].hint, "looked for it at /no/0/m, /no/1/m, /no/2/m, /no/3/m and 6 more");
}

}  // namespace
}  // namespace pongsim::assets
