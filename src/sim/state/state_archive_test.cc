#include "pongsim/state/state_archive.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pongsim {
namespace {

enum class Colour { kRed, kGreen, kBlue };

template <class T>
std::vector<std::byte> bytesOf(T value) {
  StateArchive archive;
  archive(value);
  return archive.take();
}

/// @return The value read from the bytes of one of another type.
template <class T, class Other>
T readAs(Other other) {
  const std::vector<std::byte> bytes = bytesOf(other);
  StateArchive archive(bytes);
  T value;
  archive(value);
  EXPECT_TRUE(archive.rest().empty());
  return value;
}

TEST(StateArchive, GivesBackWhatItHasTaken) {
  EXPECT_EQ(readAs<double>(-1e150), -1e150);
  EXPECT_EQ(readAs<bool>(true), true);
  EXPECT_EQ(readAs<Time>(Time(-7)), Time(-7));
  EXPECT_EQ(readAs<std::string>(std::string("a\0b", 3)), std::string("a\0b", 3));
  EXPECT_EQ(readAs<std::optional<int>>(std::optional(3)), std::optional(3));
  EXPECT_EQ(readAs<std::deque<Vector3>>(std::deque<Vector3>{{1, 2, 3}, {4, 5, 6}}).back(), Vector3(4, 5, 6));
  const Pose pose{Vector3(1, 2, 3), fromRollPitchYaw(0.1, 0.2, 0.3)};
  EXPECT_EQ(readAs<Pose>(pose), pose);
}

TEST(StateArchive, RefusesNumbersThatAreNeverWritten) {
  using Limits = std::numeric_limits<double>;
  for (const double bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(), -1e151}) {
    EXPECT_THROW(readAs<double>(bad), std::out_of_range) << bad;
    EXPECT_THROW(readAs<Vector3>(Vector3(0, bad, 0)), std::out_of_range) << bad;
    EXPECT_THROW(readAs<std::vector<double>>(std::vector<double>{1, bad}), std::out_of_range) << bad;
  }
  EXPECT_THROW(readAs<float>(std::numeric_limits<float>::infinity()), std::out_of_range);
  for (const std::int64_t bad : {std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    EXPECT_THROW(readAs<Time>(bad), std::out_of_range) << bad;
  }
  EXPECT_THROW(readAs<bool>(std::uint8_t{2}), std::out_of_range);
  EXPECT_THROW(readAs<Quaternion>(Quaternion(0, 0, 0, 0)), std::out_of_range);
  EXPECT_THROW(readAs<Quaternion>(Quaternion(2, 0, 0, 0)), std::out_of_range);
}

TEST(StateArchive, ReadsOnlyTheValuesOfAnEnumeration) {
  for (const int number : {0, 2}) {
    const std::vector<std::byte> bytes = bytesOf(number);
    StateArchive archive(bytes);
    auto colour = Colour::kGreen;
    archive(colour, Colour::kBlue);
    EXPECT_EQ(static_cast<int>(colour), number);
  }
  for (const int number : {-1, 3}) {
    const std::vector<std::byte> bytes = bytesOf(number);
    StateArchive archive(bytes);
    auto colour = Colour::kGreen;
    EXPECT_THROW(archive(colour, Colour::kBlue), std::out_of_range) << number;
  }
}

TEST(StateArchive, MakesNoRoomForMoreThanIsThere) {
  EXPECT_THROW(readAs<double>(std::uint32_t{1}), std::out_of_range);
  for (const std::uint64_t bad : {std::uint64_t{1}, std::uint64_t{1} << 62U, ~std::uint64_t{0}}) {
    EXPECT_THROW(readAs<std::string>(bad), std::out_of_range) << bad;
    EXPECT_THROW(readAs<std::vector<double>>(bad), std::out_of_range) << bad;
    EXPECT_THROW(readAs<std::deque<std::string>>(bad), std::out_of_range) << bad;
  }
}

TEST(StateArchive, ChecksOnlyWhatItReads) {
  StateArchive writing;
  EXPECT_NO_THROW(writing.check(false));
  StateArchive reading(std::span<const std::byte>{});
  EXPECT_NO_THROW(reading.check(true));
  EXPECT_THROW(reading.check(false), std::out_of_range);
}

}  // namespace
}  // namespace pongsim
