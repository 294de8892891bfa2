#include "web/world/message_form.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/world_control.pb.h>

namespace pongsim::web {
namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

std::string fault(std::string_view type, MessageForm form, std::string_view text) {
  const auto read = readMessage(type, form, bytes(text));
  const auto* error = std::get_if<std::string>(&read);
  return error == nullptr ? "" : *error;
}

TEST(MessageForm, ReadsBothForms) {
  const auto json =
      readMessage("gz.msgs.WorldControl", MessageForm::kJson, bytes(R"({"pause": true, "multiStep": 3})"));
  ASSERT_TRUE(std::holds_alternative<MessagePointer>(json));
  const std::string binary = writeMessage(*std::get<MessagePointer>(json), MessageForm::kProtobuf);
  const auto read = readMessage("WorldControl", MessageForm::kProtobuf, bytes(binary));
  ASSERT_TRUE(std::holds_alternative<MessagePointer>(read));
  const auto& control = static_cast<const ignition::msgs::WorldControl&>(*std::get<MessagePointer>(read));
  EXPECT_TRUE(control.pause());
  EXPECT_EQ(control.multi_step(), 3U);
  EXPECT_NE(writeMessage(control, MessageForm::kJson).find("\"multi_step\":3"), std::string::npos);
}

TEST(MessageForm, SaysWhatIsWrong) {
  EXPECT_EQ(fault("Nonsense", MessageForm::kJson, "{}"), "there is no message type 'Nonsense'");
  EXPECT_EQ(fault("Twist", MessageForm::kProtobuf, "\xff\xff\xff"), "3 bytes are not of type ignition.msgs.Twist");
  EXPECT_NE(fault("Twist", MessageForm::kJson, R"({"liner": 1})").find("liner"), std::string::npos);
  EXPECT_NE(fault("Twist", MessageForm::kJson, "").find("is not of type ignition.msgs.Twist"), std::string::npos);
  EXPECT_NE(fault("Twist", MessageForm::kJson, std::string(100'000, '[')), "");
}

}  // namespace
}  // namespace pongsim::web
