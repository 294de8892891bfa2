#include "plugin/fortress_systems.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace pongsim::plugin {
namespace {

TEST(FortressSystems, ListsEachLibraryOfFortressOnce) {
  const auto names = fortressSystems();
  EXPECT_EQ(names.size(), 61U);
  EXPECT_TRUE(std::ranges::is_sorted(names));
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(FortressSystems, AreMissingWhereNoLibraryNoPackageAndNotPongsimItselfDoesTheirWork) {
  const auto missing = missingSystems(std::vector<std::string>{"imu", "my-system"});
  EXPECT_EQ(missing.size(), fortressSystems().size() - 4);
  for (const char* name : {"imu", "log", "physics", "user-commands"})
    EXPECT_EQ(std::ranges::count(missing, name), 0) << name;
  EXPECT_EQ(std::ranges::count(missing, "buoyancy"), 1);
}

}  // namespace
}  // namespace pongsim::plugin
