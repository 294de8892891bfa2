#include "plugin/inspection.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::plugin {
namespace {

std::filesystem::path inspectedLibrary(const std::string& name) {
  return std::filesystem::path(PONGSIM_TEST_PLUGINS) / ("libpongsim-" + name + "-system.so");
}

TEST(Inspection, TellsOfClassesAndWhatTheySay) {
  const auto looked = Inspection::of(inspectedLibrary("counting"));
  ASSERT_TRUE(std::holds_alternative<Inspection>(looked));
  const auto& classes = std::get<Inspection>(looked).classes();
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].names, (std::vector<std::string>{"test::Counting", "test::Counter"}));
  EXPECT_EQ(classes[0].declaration.text(), "Counts steps.");
  ASSERT_EQ(classes[0].declaration.parameters().size(), 1U);
  EXPECT_EQ(classes[0].declaration.parameters()[0].fallback(), "3");
}

TEST(Inspection, SaysWhyALibraryCannotBeUsed) {
  const auto ancient = Inspection::of(inspectedLibrary("ancient"));
  ASSERT_TRUE(std::holds_alternative<std::string>(ancient));
  EXPECT_NE(std::get<std::string>(ancient).find("it is built for version 0"), std::string::npos);
}

TEST(FindLibrary, TakesTheNamesThatWorldsUse) {
  const std::vector<std::filesystem::path> path = {"/nowhere", PONGSIM_TEST_PLUGINS};
  for (const char* name : {"counting", "ignition-gazebo-counting-system", "libpongsim-counting-system.so"}) {
    EXPECT_EQ(findLibrary(path, name), inspectedLibrary("counting")) << name;
  }
  EXPECT_EQ(findLibrary(path, "no-such"), std::nullopt);
}

TEST(LibrariesIn, NamesEachSystemOnceWhereAWorldFindsIt) {
  const test::TempFolder folder;
  const auto first = folder.write("libpongsim-counting-system.so", "");
  const std::vector<std::filesystem::path> all = librariesIn({folder.path(), PONGSIM_TEST_PLUGINS});
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0], first);
  EXPECT_EQ(std::count(all.begin(), all.end(), inspectedLibrary("counting")), 0);
  EXPECT_EQ(std::count(all.begin(), all.end(), inspectedLibrary("empty")), 1);
}

}  // namespace
}  // namespace pongsim::plugin
