#include "plugin/interface_version.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "pongsim/system.hh"
#include "support/temp_folder.hh"

namespace pongsim::plugin {
namespace {

std::filesystem::path libraryOfVersion(const std::string& name) {
  return std::filesystem::path(PONGSIM_TEST_PLUGINS) / ("libpongsim-" + name + "-system.so");
}

TEST(InterfaceVersion, IsReadFromTheFile) {
  EXPECT_EQ(interfaceVersion(libraryOfVersion("counting")), kAbiVersion);
  EXPECT_EQ(interfaceVersion(libraryOfVersion("ancient")), 0U);
  EXPECT_EQ(interfaceVersion(libraryOfVersion("future")), kAbiVersion + 1);
}

TEST(InterfaceVersion, IsUnknownWhereTheFileHasNone) {
  const test::TempFolder folder;
  EXPECT_EQ(interfaceVersion(libraryOfVersion("empty")), std::nullopt);
  EXPECT_EQ(interfaceVersion(folder.write("libx.so", "not a library")), std::nullopt);
  EXPECT_EQ(interfaceVersion(folder.path() / "nothing.so"), std::nullopt);
  EXPECT_EQ(interfaceVersion(folder.path()), std::nullopt);
}

// A library that is truncated, or whose header has a wrong byte, is read without harm.
TEST(InterfaceVersion, SurvivesBrokenLibraries) {
  std::ifstream stream(libraryOfVersion("ancient"), std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  ASSERT_GT(whole.size(), 1024U);
  const test::TempFolder folder;
  for (std::size_t size = 0; size < whole.size() / 2; size += whole.size() / 60) {
    EXPECT_EQ(interfaceVersion(folder.write("cut.so", whole.substr(0, size))), std::nullopt) << size;
  }
  for (std::size_t at = 0; at < 1024; at += 3) {
    std::string broken = whole;
    broken[at] = static_cast<char>(~broken[at]);
    const auto version = interfaceVersion(folder.write("broken.so", broken));
    if (at < 4) {
      EXPECT_EQ(version, std::nullopt) << at;
    }
  }
}

}  // namespace
}  // namespace pongsim::plugin
