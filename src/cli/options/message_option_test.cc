#include "cli/options/message_option.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <string>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

/// @return What is said of a wrong message text.
std::string complaint(const char* type, const std::string& text) {
  try {
    messageOption(type, text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(MessageOption, ReadsATypeByAnyOfItsNames) {
  EXPECT_EQ(messageTypeOption("gz.msgs.Twist"), "ignition.msgs.Twist");
  EXPECT_EQ(messageTypeOption("Twist"), "ignition.msgs.Twist");
}

TEST(MessageOption, NamesTheNearestTypeOfAnUnknownOne) {
  try {
    messageTypeOption("ignition.msgs.Twst");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "unknown message type 'ignition.msgs.Twst'");
    EXPECT_EQ(error.hint(), "did you mean 'ignition.msgs.Twist'?");
  }
}

TEST(MessageOption, MakesTheMessage) {
  EXPECT_EQ(messageText(*messageOption("ignition.msgs.Int32", "data: 16777235")), "data: 16777235\n");
}

TEST(MessageOption, PutsACaretUnderThePlace) {
  EXPECT_EQ(complaint("ignition.msgs.Twist", "linear: {x: foo}"),
            "message text:1:13: field 'x' takes a number, not 'foo'\n"
            "  linear: {x: foo}\n"
            "              ^");
}

TEST(MessageOption, ShowsTheRightLineAndCountsCharactersNotBytes) {
  EXPECT_EQ(complaint("ignition.msgs.Model", "id: 1\nname: \"\xc3\xa4\" nme: 2\nid: 3"),
            "message text:2:12: field 'nme' is not in ignition.msgs.Model\n"
            "  name: \"\xc3\xa4\" nme: 2\n"
            "            ^");
}

TEST(MessageOption, ShowsAPartOfALongLine) {
  const std::string said =
      complaint("ignition.msgs.StringMsg", "data: '" + std::string(100'000, 'x') + "' wrong: " + std::string(999, '1'));
  EXPECT_LT(said.size(), 500U);
  EXPECT_NE(said.find("x' wrong: 1"), std::string::npos) << said;
}

TEST(MessageOption, HasNoPlaceToShowForBrokenUtf8) {
  EXPECT_EQ(complaint("ignition.msgs.StringMsg", "data: '\xff'"), "message text: a string is not valid UTF-8");
}

}  // namespace
}  // namespace pongsim::cli
