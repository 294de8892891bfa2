#include "cli/view/picture_plot.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace pongsim::cli {
namespace {

TEST(PicturePlot, HasTwoPixelsALetter) {
  const std::vector<std::uint8_t> pixels{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  EXPECT_EQ(picturePlot(pixels, 2, 2, 80, 25),
            "\033[38;2;1;2;3m\033[48;2;7;8;9m\u2580\033[38;2;4;5;6m\033[48;2;10;11;12m\u2580\033[0m\n");
  // nothing below the last row
  EXPECT_EQ(picturePlot({pixels.data(), 3}, 1, 1, 80, 25), "\033[38;2;1;2;3m\033[49m\u2580\033[0m\n");
}

TEST(PicturePlot, MixesWhatFallsIntoABlock) {
  const std::vector<std::uint8_t> pixels{0, 0, 0, 100, 100, 100, 100, 100, 100, 200, 200, 200};
  EXPECT_EQ(picturePlot(pixels, 2, 2, 1, 25), "\033[38;2;100;100;100m\033[49m\u2580\033[0m\n");
}

TEST(PicturePlot, FitsIntoTheTerminal) {
  const std::vector<std::uint8_t> pixels(3 * 640 * 480);
  const std::string tall = picturePlot(pixels, 640, 480, 200, 10), wide = picturePlot(pixels, 640, 480, 32, 25);
  EXPECT_EQ(std::ranges::count(tall, '\n'), 10);
  EXPECT_EQ(std::ranges::count(wide, '\n'), 12);
}

}  // namespace
}  // namespace pongsim::cli
