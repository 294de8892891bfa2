#include "ros2/services/owed_answers.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

TEST(OwedAnswers, AreGivenOnceEach) {
  OwedAnswers owed;
  int forgotten = 0;
  const std::uint64_t first = owed.owe([&] { forgotten += 1; });
  const std::uint64_t second = owed.owe([&] { forgotten += 10; });
  EXPECT_TRUE(owed.settle(first));
  EXPECT_FALSE(owed.settle(first));
  owed.forget();
  EXPECT_EQ(forgotten, 10);
  EXPECT_FALSE(owed.settle(second));
  owed.forget();
  EXPECT_EQ(forgotten, 10);
}

}  // namespace
}  // namespace pongsim::ros2
