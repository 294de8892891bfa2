#include "web/foxglove/wire.hh"

#include <gtest/gtest.h>

namespace pongsim::web::foxglove {
namespace {

using namespace std::string_literals;

std::string bytes(const Frame& frame) {
  return frame.head + std::string(reinterpret_cast<const char*>(frame.body.bytes().data()), frame.body.size());
}
auto read(std::string_view text) { return readBinary(std::as_bytes(std::span(text))); }

TEST(Wire, WritesWhatTheProtocolSays) {
  EXPECT_EQ(dataHead(0x01020304, 5), "\x01\x04\x03\x02\x01\x05\0\0\0\0\0\0\0"s);
  EXPECT_EQ(bytes(timeFrame(0x0102)), "\x02\x02\x01\0\0\0\0\0\0"s);
  EXPECT_EQ(bytes(replyFrame(1, 2, "json", Payload("{}"))), "\x03\x01\0\0\0\x02\0\0\0\x04\0\0\0json{}"s);
  EXPECT_EQ(bytes(assetFrame(7, {"mesh", "", ""})), "\x04\x07\0\0\0\0\0\0\0\0mesh"s);
  EXPECT_EQ(bytes(assetFrame(7, {"", "", "no"})), "\x04\x07\0\0\0\x01\x02\0\0\0no"s);
}

TEST(Wire, ReadsWhatClientsSay) {
  const std::string data = "\x01\x09\0\0\0hello"s;
  const auto said = read(data);
  ASSERT_TRUE(std::holds_alternative<ClientData>(said));
  EXPECT_EQ(std::get<ClientData>(said).channel, 9U);
  EXPECT_EQ(std::get<ClientData>(said).message.size(), 5U);
  const std::string asks = "\x02\x01\0\0\0\x02\0\0\0\x04\0\0\0json{}"s;
  const auto call = read(asks);
  ASSERT_TRUE(std::holds_alternative<ServiceCall>(call));
  EXPECT_EQ(std::get<ServiceCall>(call).service, 1U);
  EXPECT_EQ(std::get<ServiceCall>(call).call, 2U);
  EXPECT_EQ(std::get<ServiceCall>(call).encoding, "json");
  EXPECT_EQ(std::get<ServiceCall>(call).request.size(), 2U);
}

TEST(Wire, SaysWhatIsWrong) {
  for (const std::string& rubbish : {""s, "\x01"s, "\x01\0\0\0"s, "\x02\x01\0\0\0"s,
                                     "\x02\x01\0\0\0\x02\0\0\0\xff\xff\xff\xff"s, "\x09\0\0\0\0\0\0\0\0\0"s}) {
    EXPECT_TRUE(std::holds_alternative<std::string>(read(rubbish))) << rubbish.size();
  }
}

}  // namespace
}  // namespace pongsim::web::foxglove
