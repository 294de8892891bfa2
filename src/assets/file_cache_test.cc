#include "assets/file_cache.hh"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "support/environment_variable.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

namespace fs = std::filesystem;

class FileCacheTest : public ::testing::Test {
 protected:
  std::string read(const fs::path& file) const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const fs::path& file, std::string_view bytes) const {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path());
    return found;
  }

  const pongsim::test::TempFolder temp_;
  const fs::path folder_ = temp_.path() / "deep" / "down";
  const FileCache cache_{folder_};
};

TEST_F(FileCacheTest, GivesBackWhatItKeeps) {
  EXPECT_EQ(cache_.find("a"), std::nullopt);
  const std::string bytes("\0\xff\n", 3);
  EXPECT_EQ(cache_.keep("a", bytes), "");
  EXPECT_EQ(cache_.find("a"), bytes);
  EXPECT_EQ(cache_.find("b"), std::nullopt);
  EXPECT_EQ(cache_.keep("a", ""), "");
  EXPECT_EQ(cache_.find("a"), "");
  // one file, no temporary files
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(FileCacheTest, TakesNothingThatIsNotWhole) {
  cache_.keep("a", "0123456789");
  const fs::path file = files().at(0);
  const std::string whole = read(file);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(file, std::string_view(whole).substr(0, length));
    EXPECT_EQ(cache_.find("a"), std::nullopt) << length;
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    write(file, changed);
    EXPECT_EQ(cache_.find("a"), std::nullopt) << i;
  }
  write(file, whole + "x");
  EXPECT_EQ(cache_.find("a"), std::nullopt);
  // it is computed again
  EXPECT_EQ(cache_.keep("a", "other"), "");
  EXPECT_EQ(cache_.find("a"), "other");
}

TEST_F(FileCacheTest, TakesNothingButFiles) {
  cache_.keep("a", "x");
  const fs::path file = files().at(0);
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_EQ(cache_.find("a"), std::nullopt);
  fs::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_EQ(cache_.find("a"), std::nullopt);
}

TEST_F(FileCacheTest, SaysWhyItCanNotKeep) {
  // root may write everywhere, but not below a file
  const fs::path file = temp_.write("file", "");
  EXPECT_NE(FileCache(file / "folder").keep("a", "x"), "");
  EXPECT_EQ(FileCache(file / "folder").find("a"), std::nullopt);
  EXPECT_NE(FileCache(fs::path("/dev/full/x")).keep("a", "x"), "");
  EXPECT_NE(FileCache(fs::path("/proc/x")).keep("a", "x"), "");
  EXPECT_NE(FileCache(fs::path()).keep("a", "x"), "");
  EXPECT_EQ(FileCache(fs::path()).find("a"), std::nullopt);
}

TEST_F(FileCacheTest, LetsTheOldestGo) {
  const FileCache small(folder_, 10'000);
  const std::string bytes(1000, 'x');
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(small.keep("a" + std::to_string(i), bytes), "");
    for (const fs::path& file : files()) fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
  }
  // using the oldest one makes it recent
  EXPECT_TRUE(small.find("a0"));
  write(folder_ / "notes", std::string(1'000'000, 'y'));
  EXPECT_EQ(small.keep("b", bytes), "");
  EXPECT_TRUE(small.find("a0"));
  EXPECT_FALSE(small.find("a1"));
  EXPECT_TRUE(small.find("a8"));
  EXPECT_TRUE(small.find("b"));
  EXPECT_TRUE(fs::exists(folder_ / "notes"));
}

TEST_F(FileCacheTest, IsFilledByManyAtOnce) {
  // several threads of each process write the same files, and never see a partial one
  const std::string bytes(100'000, 'z');
  const auto work = [&] {
    bool isGood = true;
    for (int i = 0; i < 50; ++i) {
      const std::string name = std::to_string(i % 5);
      isGood = isGood && cache_.keep(name, bytes + name).empty();
      const std::optional<std::string> found = cache_.find(name);
      isGood = isGood && found && *found == bytes + name;
    }
    return isGood;
  };
  std::vector<::pid_t> children;
  for (int i = 0; i < 3; ++i) {
    const ::pid_t child = ::fork();
    if (child == 0) ::_exit(work() ? 0 : 1);
    children.push_back(child);
  }
  bool isGood = false, isOtherGood = false;
  std::thread other([&] { isOtherGood = work(); });
  isGood = work();
  other.join();
  EXPECT_TRUE(isGood);
  EXPECT_TRUE(isOtherGood);
  for (const ::pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(files().size(), 5U);
}

TEST(FileCacheFolder, IsWhereTheUserHasIt) {
  const auto folderWith = [](const char* cache, const char* home) {
    const pongsim::test::EnvironmentVariable ofCache("XDG_CACHE_HOME", cache), ofHome("HOME", home);
    return FileCache::userFolder();
  };
  EXPECT_EQ(folderWith("/x", "/home/y"), "/x/pongsim/meshes");
  EXPECT_EQ(folderWith("", "/home/y"), "/home/y/.cache/pongsim/meshes");
  EXPECT_EQ(folderWith("x", "/home/y"), "/home/y/.cache/pongsim/meshes");
  EXPECT_EQ(folderWith("", ""), "");
}

}  // namespace
}  // namespace pongsim::assets
