#include "log/command/times.hh"

#include <gtest/gtest.h>

#include <limits>

#include "shared/program/failure.hh"

namespace pongsim::log {
namespace {

TEST(Times, AreSeconds) {
  EXPECT_EQ(secondsText(12'345'000'000), "12.345000000");
  EXPECT_EQ(secondsText(1), "0.000000001");
  EXPECT_EQ(secondsText(-1'500'000'000), "-1.500000000");
  EXPECT_EQ(secondsText(std::numeric_limits<std::int64_t>::min()), "-9223372036.854775808");
}

TEST(Times, OfTheWallAreDates) {
  EXPECT_EQ(timeText(12'345'600'000), "12.345 s");
  EXPECT_EQ(timeText(1'700'000'000'123'000'000), "2023-11-14 22:13:20.123 UTC");
}

TEST(Times, AreReadFromOptions) {
  EXPECT_EQ(timeFrom("--from", "1.5"), 1'500'000'000);
  for (const char* wrong : {"", "x", "1s", "-1", "nan", "inf", "1e10"}) {
    EXPECT_THROW(timeFrom("--from", wrong), cli::UsageError) << wrong;
  }
}

}  // namespace
}  // namespace pongsim::log
