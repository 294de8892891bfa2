#include "fuel/archive.hh"

#include <gtest/gtest.h>
#include <zip.h>

#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "fuel/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::fuel {
namespace {

namespace fs = std::filesystem;

class Archive : public testing::Test {
 protected:
  fs::path zipOf(const std::map<std::string, std::string>& files) const {
    const fs::path file = folder_.path() / "a.zip";
    int error = 0;
    zip_t* zip = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    for (const auto& [name, text] : files) {
      zip_source_t* source = zip_source_buffer(zip, text.data(), text.size(), 0);
      EXPECT_GE(zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8), 0) << name;
    }
    EXPECT_EQ(zip_close(zip), 0);
    return file;
  }
  std::string unpacked(const std::map<std::string, std::string>& files, const ArchiveLimits& limits = {}) {
    fs::remove_all(target_);
    fs::create_directories(target_);
    try {
      unpack(zipOf(files), target_, limits);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  }
  std::string read(const fs::path& file) const {
    std::ifstream stream(target_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::TempFolder folder_;
  const fs::path target_ = folder_.path() / "out";
};

TEST_F(Archive, GivesFilesAndFolders) {
  EXPECT_EQ(unpacked({{"model.config", "x"}, {"./a b/c/d.dae", std::string(1'000'000, 'y')}, {"e.txt", ""}}), "");
  EXPECT_EQ(read("model.config"), "x");
  EXPECT_EQ(read("a b/c/d.dae"), std::string(1'000'000, 'y'));
  EXPECT_TRUE(fs::exists(target_ / "e.txt"));
}

TEST_F(Archive, StaysInItsFolder) {
  for (const char* name : {"../a", "a/../../b", "/a", "a\\..\\b", "C:/a", ".."}) {
    EXPECT_NE(unpacked({{"good", "x"}, {name, "x"}}).find("is outside the model's folder"), std::string::npos) << name;
    // all entries are checked before the first is written
    EXPECT_FALSE(fs::exists(target_ / "good"));
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "a"));
}

TEST_F(Archive, HasLimits) {
  EXPECT_NE(unpacked({{"a", "x"}, {"b", "x"}}, {.files = 1}).find("it has 2 files"), std::string::npos);
  EXPECT_NE(unpacked({{"a", "xxxx"}}, {.bytes = 3}).find("would become"), std::string::npos);
  EXPECT_NE(unpacked({{"a", std::string(1'000'000, 'x')}}, {.ratio = 10, .free = 0}).find("would become 1000000"),
            std::string::npos);
  EXPECT_EQ(unpacked({{"a", std::string(1'000'000, 'x')}}, {.ratio = 10, .free = 1'000'000}), "");
}

TEST_F(Archive, OutlivesWhatIsDamaged) {
  const fs::path file = zipOf({{"model.config", "<model/>"}, {"a/b.txt", std::string(500, 'x')}, {"c", "some text"}});
  std::ifstream stream(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  std::mt19937 random(1);
  const auto below = [&](std::size_t size) { return random() % size; };
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::string text = whole;
    for (std::size_t count = 1 + below(4); count > 0; --count) text[below(text.size())] = static_cast<char>(random());
    if (i % 5 == 0) text.resize(below(text.size()));
    const fs::path damaged = folder_.write("damaged.zip", text);
    fs::remove_all(target_);
    fs::create_directories(target_);
    try {
      unpack(damaged, target_);
    } catch (const Failure&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
  // nothing was unpacked beside the target folder
  const auto count = std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  EXPECT_EQ(count, 3);
}

TEST_F(Archive, SaysWhereItIsNone) {
  const fs::path file = folder_.write("b.zip", "PK and no more");
  EXPECT_THROW(unpack(file, folder_.path()), PassingFailure);
  EXPECT_THROW(unpack(folder_.path() / "nowhere", folder_.path()), PassingFailure);
}

}  // namespace
}  // namespace pongsim::fuel
