#include "pongsim/random.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace pongsim {
namespace {

TEST(Random, RepeatsForTheSameSeedAndName) {
  Random first(7, "imu"), second(7, "imu");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(first.uniform(), second.uniform());
}

TEST(Random, DiffersForAnotherSeedOrName) {
  EXPECT_NE(Random(7, "imu").uniform(), Random(8, "imu").uniform());
  EXPECT_NE(Random(7, "imu").uniform(), Random(7, "lidar").uniform());
}

TEST(Random, SplitsOffStreamsThatGoTheirOwnWay) {
  Random whole(7, "imu"), same(7, "imu");
  Random part = whole.split("x"), samePart = same.split("x");
  EXPECT_EQ(part.uniform(), samePart.uniform());
  part.uniform();
  EXPECT_EQ(whole.uniform(), same.uniform());
  EXPECT_NE(Random(7, "imu").split("x").uniform(), Random(7, "imu").split("y").uniform());
  EXPECT_NE(Random(7, "imu").split("x").uniform(), Random(8, "imu").split("x").uniform());
}

TEST(Random, GivesTheSameAtANumberWhateverWasDrawnThere) {
  const Random random(7, "imu");
  Random first = random.at(1);
  first.normal(0, 1);
  EXPECT_EQ(random.at(1).uniform(), Random(7, "imu").at(1).uniform());
  EXPECT_NE(random.at(1).uniform(), random.at(2).uniform());
  EXPECT_NE(random.at(1).uniform(), Random(7, "lidar").at(1).uniform());
}

TEST(Random, SpreadsUniformlyOverNumbers) {
  const Random random(1, "test");
  constexpr int kCount = 100'000;
  double sum = 0, neighbours = 0, last = 0;
  for (int i = 0; i < kCount; ++i) {
    // milliseconds in nanoseconds, as it is used
    const double value = random.at(static_cast<std::uint64_t>(i) * 1'000'000).uniform() - 0.5;
    sum += value;
    neighbours += value * last;
    last = value;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.005);
  EXPECT_NEAR(neighbours / kCount, 0, 0.002);
}

TEST(Random, SpreadsUniformlyOverTheUnitInterval) {
  Random random(1, "test");
  constexpr int kCount = 100'000;
  double sum = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.uniform();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.005);
}

// from such a stream a normally distributed number might never come
TEST(Random, RefusesAStreamThatRepeatsItself) {
  Random random(1, "test");
  StateArchive taking;
  random.transfer(taking);
  std::vector<std::byte> bytes = taking.take();
  std::fill_n(bytes.begin(), 2 * sizeof(std::uint64_t), std::byte{0});
  StateArchive giving(bytes);
  EXPECT_THROW(random.transfer(giving), std::out_of_range);
}

TEST(Random, HasTheMeanAndDeviationAskedFor) {
  Random random(1, "test");
  constexpr int kCount = 100'000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.normal(3, 2);
    sum += value;
    squares += (value - 3) * (value - 3);
  }
  EXPECT_NEAR(sum / kCount, 3, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kCount), 2, 0.03);
}

}  // namespace
}  // namespace pongsim
