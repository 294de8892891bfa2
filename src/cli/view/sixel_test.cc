#include "cli/view/sixel.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "cli/view/shrink.hh"

namespace pongsim::cli {
namespace {

/// What a terminal makes of sixels.
struct SixelScreen {
  explicit SixelScreen(const std::string& text) {
    const std::string begin = "\033P0;1q\"1;1;";
    EXPECT_TRUE(text.starts_with(begin));
    EXPECT_TRUE(text.ends_with("\033\\"));
    const char* next = text.c_str() + begin.size();
    width = number(next);
    height = number(++next);
    pixels.assign(3 * width * height, 0);
    std::size_t column = 0, top = 0, run = 1;
    for (; *next != '\033'; ++next) {
      if (*next == '#') {
        chooseColor(next);
      } else if (*next == '!') {
        run = number(++next);
        --next;
      } else if (*next == '$' || *next == '-') {
        if (*next == '-') top += 6;
        column = 0;
      } else {
        for (; run > 0; --run) paint(*next - '?', column++, top);
        run = 1;
      }
    }
  }

  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  /// Pixels that were painted, each time.
  std::size_t painted = 0;

 private:
  static std::size_t number(const char*& text) {
    char* end = nullptr;
    const unsigned long value = std::strtoul(text, &end, 10);
    text = end;
    return value;
  }

  /// Reads "#7" or "#7;2;0;20;100"; `next` is left on the last sign.
  void chooseColor(const char*& next) {
    color = number(++next);
    if (*next == ';') {
      EXPECT_EQ(number(++next), 2U);
      for (std::size_t i = 0; i < 3; ++i) {
        colors[color].push_back(static_cast<std::uint8_t>(std::lround(static_cast<double>(number(++next)) * 2.55)));
      }
    }
    --next;
  }

  void paint(int bits, std::size_t column, std::size_t top) {
    for (std::size_t row = 0; row < 6; ++row) {
      if ((bits >> row & 1) == 0) continue;
      ASSERT_LT(column, width);
      ASSERT_LT(top + row, height);
      ++painted;
      for (std::size_t i = 0; i < 3; ++i) pixels[3 * ((top + row) * width + column) + i] = colors.at(color).at(i);
    }
  }

  std::size_t color = 0;
  std::map<std::size_t, std::vector<std::uint8_t>> colors;
};

TEST(Sixel, ShowsColorsThatItHasAsTheyAre) {
  // 11 rows are a whole band and a part of one
  constexpr std::size_t kWidth = 9, kHeight = 11;
  std::vector<std::uint8_t> pixels;
  for (std::size_t i = 0; i < kWidth * kHeight; ++i) {
    for (const std::size_t shade : {i % 6, i / 6 % 6, i / kWidth % 6}) {
      pixels.push_back(static_cast<std::uint8_t>(shade * 51));
    }
  }
  const SixelScreen screen(sixels(pixels, kWidth, kHeight));
  EXPECT_EQ(screen.width, kWidth);
  EXPECT_EQ(screen.height, kHeight);
  EXPECT_EQ(screen.pixels, pixels);
  EXPECT_EQ(screen.painted, kWidth * kHeight);
}

TEST(Sixel, ShowsOtherColorsByMixingThoseThatItHas) {
  constexpr std::size_t kEdge = 48, kBlocks = 6;
  std::vector<std::uint8_t> pixels;
  for (std::size_t row = 0; row < kEdge; ++row) {
    for (std::size_t column = 0; column < kEdge; ++column) {
      for (const std::size_t value : {column * 5, row * 5, 70 + column}) {
        pixels.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  const SixelScreen screen(sixels(pixels, kEdge, kEdge));
  EXPECT_EQ(screen.painted, kEdge * kEdge);
  const std::vector<std::uint8_t> wanted = shrink(pixels, kEdge, kEdge, kBlocks, kBlocks);
  const std::vector<std::uint8_t> shown = shrink(screen.pixels, kEdge, kEdge, kBlocks, kBlocks);
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(shown[i], wanted[i], 6) << i;
}

TEST(Sixel, WritesWhatRepeatsOnce) {
  const std::vector<std::uint8_t> black(std::size_t{3} * 500 * 6);
  EXPECT_EQ(sixels(black, 500, 6), "\033P0;1q\"1;1;500;6#0;2;0;0;0#0!500~$-\033\\");
}

}  // namespace
}  // namespace pongsim::cli
