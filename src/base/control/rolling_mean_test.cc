#include "pongsim/control/rolling_mean.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace pongsim {
namespace {

TEST(RollingMean, IsThatOfTheLastValues) {
  RollingMean<3> mean;
  EXPECT_EQ(mean.mean(), 0);
  mean.add(1);
  EXPECT_EQ(mean.mean(), 1);
  mean.add(2);
  mean.add(6);
  EXPECT_EQ(mean.mean(), 3);
  mean.add(7);
  EXPECT_EQ(mean.mean(), 5);
}

TEST(RollingMean, RefusesPlacesOutsideOfIt) {
  RollingMean<3> mean;
  StateArchive taking;
  mean.transfer(taking);
  const std::vector<std::byte> sound = taking.take();
  // behind the values: the next place, and their number
  for (const std::size_t place : {3 * sizeof(double), 3 * sizeof(double) + sizeof(std::size_t)}) {
    std::vector<std::byte> bytes = sound;
    bytes[place] = std::byte{4};
    StateArchive giving(bytes);
    EXPECT_THROW(mean.transfer(giving), std::out_of_range);
  }
}

}  // namespace
}  // namespace pongsim
