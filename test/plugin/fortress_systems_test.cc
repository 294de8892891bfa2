#include "plugin/fortress_systems.hh"

#include <gtest/gtest.h>

#include <algorithm>

namespace pongsim::plugin {
namespace {

TEST(FortressSystems, ListsEachLibraryOfFortressOnce) {
  const auto names = fortressSystems();
  EXPECT_EQ(names.size(), 61U);
  EXPECT_TRUE(std::ranges::is_sorted(names));
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace pongsim::plugin
