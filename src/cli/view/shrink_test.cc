#include "cli/view/shrink.hh"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace pongsim::cli {
namespace {

TEST(Shrink, TakesTheMeanOfWhatFallsTogether) {
  const std::vector<std::uint8_t> pixels{0, 10, 20, 100, 30, 20, 50, 60, 70, 100, 10, 20, 200, 30, 20, 0, 0, 255};
  EXPECT_EQ(shrink(pixels, 3, 2, 3, 2), pixels);
  EXPECT_EQ(shrink(pixels, 3, 2, 1, 1), (std::vector<std::uint8_t>{75, 23, 67}));
  // the first of three goes alone
  EXPECT_EQ(shrink(pixels, 3, 2, 2, 1), (std::vector<std::uint8_t>{50, 10, 20, 87, 30, 91}));
}

TEST(Shrink, FitsIntoWhatThereIs) {
  const std::vector<std::uint8_t> pixels(3 * 60 * 40, 7);
  const auto sizeIn = [&pixels](double across, double down) {
    const SmallPicture small = shrinkInto(pixels, 60, 40, across, down);
    EXPECT_EQ(small.pixels, std::vector<std::uint8_t>(3 * small.across * small.down, 7));
    return std::pair(small.across, small.down);
  };
  EXPECT_EQ(sizeIn(100, 100), std::pair(std::size_t{60}, std::size_t{40}));
  EXPECT_EQ(sizeIn(20, 100), std::pair(std::size_t{20}, std::size_t{13}));
  EXPECT_EQ(sizeIn(100, 10), std::pair(std::size_t{15}, std::size_t{10}));
  EXPECT_EQ(sizeIn(100, 0.5), std::pair(std::size_t{1}, std::size_t{1}));
}

}  // namespace
}  // namespace pongsim::cli
