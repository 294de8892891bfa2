#include "cli/shrink.hh"

#include <gtest/gtest.h>

namespace pongsim::cli {
namespace {

TEST(Shrink, TakesTheMeanOfWhatFallsTogether) {
  const std::vector<std::uint8_t> pixels{0, 10, 20, 100, 30, 20, 50, 60, 70, 100, 10, 20, 200, 30, 20, 0, 0, 255};
  EXPECT_EQ(shrink(pixels, 3, 2, 3, 2), pixels);
  EXPECT_EQ(shrink(pixels, 3, 2, 1, 1), (std::vector<std::uint8_t>{75, 23, 67}));
  // the first of three goes alone
  EXPECT_EQ(shrink(pixels, 3, 2, 2, 1), (std::vector<std::uint8_t>{50, 10, 20, 87, 30, 91}));
}

}  // namespace
}  // namespace pongsim::cli
