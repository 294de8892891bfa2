#include "physics/shapes/margin.hh"

#include <gtest/gtest.h>

namespace pongsim::physics {
namespace {

TEST(Margin, IsAHundredthOfWhatIsSmallAndAMillimetreAtMost) {
  EXPECT_DOUBLE_EQ(marginFor(0.01), 0.0001);
  EXPECT_DOUBLE_EQ(marginFor(0.1), 0.001);
  EXPECT_DOUBLE_EQ(marginFor(50), 0.001);
}

}  // namespace
}  // namespace pongsim::physics
