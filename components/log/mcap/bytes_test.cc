#include "log/mcap/bytes.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"

namespace pongsim::log {
namespace {

TEST(Bytes, AreReadAsTheyWereWritten) {
  std::string bytes;
  ByteWriter writer(bytes);
  writer.number(std::uint8_t{0xfe});
  writer.number(std::uint16_t{0x1234});
  writer.number(std::uint32_t{0xdeadbeef});
  writer.number(std::uint64_t{0x0123456789abcdef});
  writer.text("ab");
  writer.raw("rest");
  EXPECT_EQ(bytes.substr(0, 3), std::string("\xfe\x34\x12"));

  ByteReader reader(bytes, 100, "thing");
  EXPECT_EQ(reader.number<std::uint8_t>(), 0xfe);
  EXPECT_EQ(reader.number<std::uint16_t>(), 0x1234);
  EXPECT_EQ(reader.number<std::uint32_t>(), 0xdeadbeefU);
  EXPECT_EQ(reader.number<std::uint64_t>(), 0x0123456789abcdefU);
  EXPECT_EQ(reader.text(), "ab");
  EXPECT_EQ(reader.offset(), 100U + 21U);
  EXPECT_EQ(reader.rest(), "rest");
  EXPECT_TRUE(reader.isAtEnd());
}

TEST(Bytes, AreNotReadBeyondTheirEnd) {
  std::string bytes;
  ByteWriter(bytes).number(std::uint32_t{4000000000});
  bytes += "xyz";
  ByteReader reader(bytes, 1000, "channel");
  try {
    reader.text();
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "byte 1004: the channel should have 4000000000 more bytes, but has 3");
  }
}

}  // namespace
}  // namespace pongsim::log
