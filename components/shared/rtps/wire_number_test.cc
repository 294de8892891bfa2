#include "shared/rtps/wire_number.hh"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace pongsim::shared {

TEST(WireNumber, HasItsLeastSignificantByteFirstAndComesBack) {
  std::array<std::byte, 9> bytes{};
  std::span<std::byte> place = bytes;
  putNumber(0x0102030405060708, 8, place);
  putNumber(0xff, 1, place);
  EXPECT_TRUE(place.empty());
  EXPECT_EQ(bytes[0], std::byte{8});
  EXPECT_EQ(bytes[7], std::byte{1});
  std::span<const std::byte> rest = bytes;
  EXPECT_EQ(takeNumber(8, rest), 0x0102030405060708);
  EXPECT_EQ(takeNumber(1, rest), 0xff);
  EXPECT_TRUE(rest.empty());
}

TEST(WireNumber, HasEitherByteOrder) {
  std::array<std::uint8_t, 3> bytes{};
  const std::span<std::uint8_t> place = bytes;
  writeNumber(0x010203, place, false);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 3>{1, 2, 3}));
  EXPECT_EQ(readNumber(std::span<const std::uint8_t>(bytes), false), 0x010203);
  EXPECT_EQ(readNumber(std::span<const std::uint8_t>(bytes), true), 0x030201);
  writeNumber(0xff010203, place, true);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 3>{3, 2, 1})) << "what has no room is left out";
}

}  // namespace pongsim::shared
