#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>

#include "pongsim/message.hh"

namespace pongsim {
namespace {

/// @return The message's JSON, or what is wrong as "line:column: message | hint".
std::string read(const char* type, const std::string& text) {
  const MessagePointer message = newMessage(type);
  const std::optional<MessageError> error = parseMessage(text, *message);
  if (!error) return messageJson(*message);
  return std::to_string(error->line) + ":" + std::to_string(error->column) + ": " + error->message +
         (error->hint.empty() ? "" : " | " + error->hint);
}

struct Case {
  const char* type;
  std::string text;
  const char* result;
};

std::ostream& operator<<(std::ostream& stream, const Case& each) { return stream << each.type << " " << each.text; }

class GoodText : public testing::TestWithParam<Case> {};

TEST_P(GoodText, IsRead) { EXPECT_EQ(read(GetParam().type, GetParam().text), GetParam().result); }

const Case kGood[] = {
    {"Twist", "linear: {x: 0.5}, angular: {z: 0.05}", R"({"linear":{"x":0.5},"angular":{"z":0.05}})"},
    {"Twist", "linear: {x: 6.0} angular: {z: 0.4}", R"({"linear":{"x":6},"angular":{"z":0.4}})"},
    {"Twist", "linear:{x:0.2}", R"({"linear":{"x":0.2}})"},
    {"Twist", "angular {z: 0}", R"({"angular":{}})"},
    {"Twist", "linear < x: 1 >; angular: <>", R"({"linear":{"x":1},"angular":{}})"},
    {"Twist", "linear {\n  x: 1 # forward\n}\n", R"({"linear":{"x":1}})"},
    {"Boolean", "data:true", R"({"data":true})"},
    {"Boolean", "data: 1", R"({"data":true})"},
    {"Model", "pose { position { } }", R"({"pose":{"position":{}}})"},
    {"Model", "link [{name: 'a'}, {name: 'b'}]", R"({"link":[{"name":"a"},{"name":"b"}]})"},
    {"Actuators", "velocity:[700, 700, 700, 700]", R"({"velocity":[700,700,700,700]})"},
    {"Actuators", "velocity: 1 velocity: 2", R"({"velocity":[1,2]})"},
    {"StringMsg", "data: \"a\" 'b'", R"({"data":"ab"})"},
    {"StringMsg", "data: '\xc3\xa4'", "{\"data\":\"\xc3\xa4\"}"},
    {"Entity", "name: \"box\" type: MODEL", R"({"name":"box","type":"MODEL"})"},
    {"Int32", "data: -0x10", R"({"data":-16})"},
    {"Double", "data: 1.5f", R"({"data":1.5})"},
    {"Double", "data: -inf", R"({"data":"-Infinity"})"},
    {"Twist", "", "{}"},
    {"Twist", " ", "{}"},
};
INSTANTIATE_TEST_SUITE_P(ParseMessage, GoodText, testing::ValuesIn(kGood));

class BadText : public testing::TestWithParam<Case> {};

TEST_P(BadText, IsRefusedWithItsPlaceAndReason) {
  EXPECT_EQ(read(GetParam().type, GetParam().text), GetParam().result);
}

const Case kBad[] = {
    {"Twist", "lineer: {x: 0.5}", "1:1: field 'lineer' is not in ignition.msgs.Twist | did you mean 'linear'?"},
    {"Twist", "linear {\n\tw : 1\n}", "2:2: field 'w' is not in ignition.msgs.Vector3d | its fields: header, x, y, z"},
    {"Entity", "id: 3, type: MDEL",
     "1:14: 'MDEL' is not a value of field 'type' | did you mean 'MODEL'? "
     "its values: NONE, LIGHT, MODEL, LINK, VISUAL, COLLISION, SENSOR, JOINT"},
    {"Twist", "linear: {x: foo}", "1:13: field 'x' takes a number, not 'foo'"},
    {"Twist", "linear: {x: \"1\"}", "1:13: field 'x' takes a number, not \"1\""},
    {"Twist", "linear: 5", "1:9: field 'linear' takes {...} with the fields of ignition.msgs.Vector3d, not '5'"},
    {"Twist", "linear: [{x: 1}]", "1:9: field 'linear' takes one value, not a list"},
    {"Twist", "linear: {x: 1, x: 2}", "1:16: field 'x' is set twice but takes one value"},
    {"Boolean", "data: maybe", "1:7: field 'data' takes true or false, not 'maybe'"},
    {"Boolean", "data: 5", "1:7: field 'data' takes true or false, not '5'"},
    {"Int32", "data: 1.5", "1:7: field 'data' takes a whole number, not '1.5'"},
    {"Int32", "data: 5000000000", "1:7: '5000000000' is out of range for field 'data' (int32)"},
    {"UInt32", "data: -1", "1:7: field 'data' takes a whole number from 0, not '-'"},
    {"StringMsg", "data: 5", "1:7: field 'data' takes text in quotes, not '5'"},
    {"StringMsg", "data: \"abc", "1:11: the string has no closing quote"},
    {"StringMsg", "data: 'x\xff'", "0:0: a string is not valid UTF-8"},
    {"StringMsg", "data: '\\377'", "0:0: a string is not valid UTF-8"},
    {"Twist", "linear: {x: 0.5", "1:16: the text ends before the '}' of field 'linear'"},
    {"Twist", "linear:", "1:8: the text ends before the value of field 'linear'"},
    {"Int32", "data:", "1:6: the text ends before the value of field 'data'"},
    {"Actuators", "velocity: [1", "1:13: the text ends before a ','"},
    {"Twist", "linear {x: 1}}", "1:14: '}' without '{'"},
    {"Twist", "linear {x: 1]", "1:13: a field's name expected here, not ']'"},
    {"Int32", "data 5", "1:6: ':' expected here, not '5'"},
    {"Twist", std::string("lin\0ear", 7), "1:4: invalid control characters encountered in text"},
};
INSTANTIATE_TEST_SUITE_P(ParseMessage, BadText, testing::ValuesIn(kBad));

TEST(ParseMessage, ForgetsWhatTheMessageHeldBefore) {
  const MessagePointer message = newMessage("Twist");
  ASSERT_FALSE(parseMessage("linear {x: 1}", *message));
  ASSERT_FALSE(parseMessage("angular {z: 2}", *message));
  EXPECT_EQ(messageJson(*message), R"({"angular":{"z":2}})");
}

TEST(ParseMessage, BoundsTheNesting) {
  std::string text;
  for (int depth = 0; depth < 100'000; ++depth) text += "model {";
  EXPECT_NE(read("Model", text).find("nested more than 100 deep"), std::string::npos);
  EXPECT_NE(read("Model", std::string(100'000, '{')), "");
  EXPECT_NE(read("Model", "model " + std::string(100'000, '[')), "");
}

TEST(ParseMessage, ReadsHugeText) {
  const std::string payload(8'000'000, 'x');
  const MessagePointer message = newMessage("StringMsg");
  ASSERT_FALSE(parseMessage("data: '" + payload + "'", *message));
  EXPECT_EQ(message->ByteSizeLong(), payload.size() + 5);
}

TEST(ParseMessage, ShortensLongWordsInItsMessages) {
  const std::string error = read("Twist", std::string(1'000'000, 'x') + ": 1");
  EXPECT_LT(error.size(), 300U);
  EXPECT_TRUE(error.starts_with("1:1: field 'xxx")) << error;
}

TEST(ParseMessage, SaysNothingOnStandardError) {
  testing::internal::CaptureStderr();
  for (const Case& bad : kBad) read(bad.type, bad.text);
  newMessage("StringMsg")->ParseFromString("\x12\x01\xff");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pongsim
