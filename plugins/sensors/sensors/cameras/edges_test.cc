#include "edges.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pongsim::edges_test {
namespace {

using Eigen::Vector2d;

constexpr std::uint32_t kWidth = 20, kHeight = 10;

/// @return The green pixels, row by row, as '#'.
std::string drawn(const std::vector<Vector2d>& edges) {
  std::vector<std::uint8_t> pixels(std::size_t{3} * kWidth * kHeight, 7);
  drawEdges(edges, kWidth, kHeight, pixels);
  std::string text;
  for (std::size_t i = 0; i < pixels.size(); i += 3) {
    text += pixels[i] == 0 && pixels[i + 1] == 255 && pixels[i + 2] == 0 ? '#' : '.';
  }
  return text;
}

TEST(Edges, OfABoxAreItsOutline) {
  std::vector<Vector2d> edges;
  addEdges(Eigen::AlignedBox2d(Vector2d(3, 2), Vector2d(12, 7)), edges);
  const std::string text = drawn(edges);
  for (std::uint32_t row = 0; row < kHeight; ++row) {
    for (std::uint32_t column = 0; column < kWidth; ++column) {
      const bool isInside = column >= 3 && column <= 12 && row >= 2 && row <= 7;
      const bool isOn = isInside && (column == 3 || column == 12 || row == 2 || row == 7);
      EXPECT_EQ(text[row * kWidth + column], isOn ? '#' : '.') << column << ' ' << row;
    }
  }
}

TEST(Edges, EndAtTheImage) {
  std::vector<Vector2d> edges;
  addEdges(Eigen::AlignedBox2d(Vector2d(-1e9, 2), Vector2d(1e9, 1e9)), edges);
  // the upper one alone is seen
  const std::string text = drawn(edges);
  EXPECT_EQ(std::ranges::count(text, '#'), kWidth);
  EXPECT_EQ(text.substr(2 * kWidth, kWidth), std::string(kWidth, '#'));
  edges.clear();
  addEdges(Eigen::AlignedBox2d(Vector2d(30, 2), Vector2d(40, 7)), edges);
  EXPECT_EQ(std::ranges::count(drawn(edges), '#'), 0);
}

TEST(Edges, OfABoxInSpaceAreProjected) {
  PictureView view;
  view.fx = view.fy = 10;
  view.cx = 10;
  view.cy = 5;
  std::vector<Vector2d> edges;
  // renderers look along -z
  addEdges(TurnedBox{{{1, 0, -5}, Quaternion::Identity()}, {2, 2, 2}}, view, edges);
  ASSERT_EQ(edges.size(), 24U);
  Eigen::AlignedBox2d bounds;
  for (const Vector2d& end : edges) bounds.extend(end);
  // the nearer face, 4 m ahead, from 0 to 2 m to the right
  EXPECT_TRUE(bounds.min().isApprox(Vector2d(10, 5 - 10 / 4.0), 1e-9)) << bounds.min().transpose();
  EXPECT_TRUE(bounds.max().isApprox(Vector2d(10 + 20 / 4.0, 5 + 10 / 4.0), 1e-9)) << bounds.max().transpose();
  edges.clear();
  addEdges(TurnedBox{{{1, 0, -0.5}, Quaternion::Identity()}, {2, 2, 2}}, view, edges);
  EXPECT_TRUE(edges.empty());
}

}  // namespace
}  // namespace pongsim::edges_test
