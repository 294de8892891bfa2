#include "cli/plugin/plugin_template.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

TEST(PluginTemplate, TakesNamesOfFiles) {
  for (const char* name : {"a", "my-system", "robot2-arm"}) EXPECT_EQ(pluginNameError(name), std::nullopt) << name;
  for (const char* name : {"", "My-system", "2nd", "my_system", "my--system", "my-", "-my", "../up", "ö"}) {
    EXPECT_NE(pluginNameError(name), std::nullopt) << name;
  }
}

// that they build is seen in test/package
TEST(PluginTemplate, WritesFilesWithTheNameInThem) {
  const test::TempFolder folder;
  ASSERT_EQ(writePluginTemplate(folder.path() / "my-own-system", "my-own-system"), std::nullopt);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "my-own-system")) {
    files.push_back(entry.path().filename().string());
    std::ifstream stream(entry.path());
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_EQ(text.find('@'), std::string::npos) << entry.path();
    EXPECT_TRUE(text.find("my-own-system") != std::string::npos || text.find("MyOwnSystem") != std::string::npos ||
                text.find("whether the box rises") != std::string::npos)
        << entry.path();
  }
  std::ranges::sort(files);
  EXPECT_EQ(files, (std::vector<std::string>{"CMakeLists.txt", "README.md", "my_own_system.cc", "my_own_system.sdf",
                                             "my_own_system_test.cc"}));
}

TEST(PluginTemplate, LeavesAloneWhatIsThere) {
  const test::TempFolder folder;
  folder.write("a/b.txt", "mine");
  EXPECT_EQ(writePluginTemplate(folder.path() / "a", "a"), "'" + (folder.path() / "a").string() + "' already exists");
}

}  // namespace
}  // namespace pongsim::cli
