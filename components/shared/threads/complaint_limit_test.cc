#include "shared/threads/complaint_limit.hh"

#include <gtest/gtest.h>

namespace pongsim::shared {
namespace {

TEST(ComplaintLimit, LetsOneThroughASecondAndCountsTheOthers) {
  ComplaintLimit limit;
  const std::chrono::steady_clock::time_point start{};
  EXPECT_EQ(limit.pass(start), 0U);
  for (int ms = 1; ms < 1000; ms += 100) EXPECT_EQ(limit.pass(start + std::chrono::milliseconds(ms)), std::nullopt);
  EXPECT_EQ(limit.pass(start + std::chrono::seconds(1)), 10U);
  EXPECT_EQ(limit.pass(start + std::chrono::seconds(2)), 0U);
}

}  // namespace
}  // namespace pongsim::shared
