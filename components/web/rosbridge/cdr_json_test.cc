#include "web/rosbridge/cdr_json.hh"

#include <gtest/gtest.h>

namespace pongsim::web::rosbridge {
namespace {

using nlohmann::json;

constexpr const char* kText =
    "string name\nuint8 small\nfloat64 real\nfloat32[] ranges\nuint8[] data\nint16[2] pair\nbool on\na/B inner\n"
    "a/B[] list\na/E empty\nint64 big\n==\nMSG: a/B\nint32 n\nstring text\n==\nMSG: a/E\n";

class CdrJson : public testing::Test {
 protected:
  std::string write(const json& message) {
    const Outcome<std::string> written = writeCdr(definition_, message);
    EXPECT_TRUE(written) << written.error;
    return written ? *written.value : "";
  }
  std::string refusal(const json& message) { return writeCdr(definition_, message).error; }
  json read(std::string_view bytes, Form form = Form::kJson) {
    return readCdr(definition_, std::as_bytes(std::span(bytes)), form);
  }

  RosDefinition definition_ = *readDefinition(kText);
};

const json kFull = {{"name", "abc"},
                    {"small", 7},
                    {"real", -0.5},
                    {"ranges", {1.5, 2.5}},
                    {"data", "AQID"},
                    {"pair", {-1, 2}},
                    {"on", true},
                    {"inner", {{"n", -3}, {"text", ""}}},
                    {"list", {{{"n", 1}, {"text", "x"}}, {{"n", 2}, {"text", "yy"}}}},
                    {"empty", json::object()},
                    {"big", 9007199254740993}};

TEST_F(CdrJson, ReadsWhatItHasWritten) {
  EXPECT_EQ(read(write(kFull)), kFull);
  json bytes = kFull;
  bytes["data"] = {1, 2, 3};
  EXPECT_EQ(read(write(bytes)), kFull) << "bytes may be a list, too";
  EXPECT_EQ(read(write(json::object()))["pair"], json({0, 0})) << "what is left out is zero";
}

TEST_F(CdrJson, HasTheLayoutOfCdr) {
  const RosDefinition definition = *readDefinition("uint8 a\nfloat64 b\nstring c\n");
  const Outcome<std::string> written = writeCdr(definition, {{"a", 1}, {"b", 1.0}, {"c", "hi"}});
  ASSERT_TRUE(written);
  const std::string_view expected(
      "\0\1\0\0"
      "\1\0\0\0\0\0\0\0"
      "\0\0\0\0\0\0\xf0\x3f"
      "\3\0\0\0hi\0",
      27);
  EXPECT_EQ(*written.value, expected);
}

TEST_F(CdrJson, HasTypedArraysForCbor) {
  const json message = read(write(kFull), Form::kCbor);
  ASSERT_TRUE(message["ranges"].is_binary());
  EXPECT_EQ(message["ranges"].get_binary().subtype(), 85U);
  EXPECT_EQ(message["ranges"].get_binary().size(), 8U);
  EXPECT_EQ(message["data"].get_binary().subtype(), 64U);
  EXPECT_EQ(message["list"], kFull["list"]);
}

TEST_F(CdrJson, SaysWhatIsWrong) {
  EXPECT_EQ(refusal({{"nam", "x"}}), "nam is no field of the type");
  EXPECT_EQ(refusal({{"inner", {{"n", "x"}}}}), "inner.n is not a number");
  EXPECT_EQ(refusal({{"list", {{{"n", 1}}, {{"text", 1}}}}}), "list[1].text is not a text");
  EXPECT_EQ(refusal({{"small", 256}}), "small does not fit its type");
  EXPECT_EQ(refusal({{"small", 1.5}}), "small does not fit its type");
  EXPECT_EQ(refusal({{"small", -1}}), "small does not fit its type");
  EXPECT_EQ(refusal({{"pair", {1}}}), "pair does not have 2 entries");
  EXPECT_EQ(refusal({{"data", "??"}}), "data is not in base64");
  EXPECT_EQ(refusal({{"inner", 3}}), "inner is not an object");
  EXPECT_EQ(refusal(json(3)), "the message is not an object");
}

TEST_F(CdrJson, IsNullWhereBytesAreMissing) {
  const std::string bytes = write(kFull);
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_TRUE(read(bytes.substr(0, size)).is_null()) << size;
}

}  // namespace
}  // namespace pongsim::web::rosbridge
