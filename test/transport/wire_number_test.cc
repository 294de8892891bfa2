#include "transport/wire_number.hh"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace pongsim::transport {

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

}  // namespace pongsim::transport
