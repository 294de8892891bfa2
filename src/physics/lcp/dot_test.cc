#include "physics/lcp/dot.hh"

#include <gtest/gtest.h>

#include <cstddef>

namespace pongsim::physics {
namespace {

TEST(Dot, IsTheSumOfTheProducts) {
  const double a[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const double b[] = {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2};
  for (std::size_t count = 0; count <= 11; ++count) {
    EXPECT_EQ(dot(a, b, count), static_cast<double>(count * (count + 1))) << count;
  }
}

// what the direct solver's bits stand on: the four sums, each from the front, then the two pairs of them
TEST(Dot, AddsInTheSameOrderAlways) {
  const double huge = 0x1p60;
  const double a[] = {huge, 1, -huge, 1, -huge, 1, huge, 1, 3};
  const double b[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
  // one after the other, the ones beside the huge numbers are lost
  double fromTheFront = 0;
  for (std::size_t i = 0; i < 9; ++i) fromTheFront += a[i] * b[i];
  EXPECT_NE(fromTheFront, 7);
  EXPECT_EQ(dot(a, b, 9), 7);
}

}  // namespace
}  // namespace pongsim::physics
