#include "msgs/encoding/message_template.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include "pongsim/message.hh"

namespace pongsim::msgs {
namespace {

TEST(MessageTemplate, HasEveryField) {
  EXPECT_EQ(messageTemplate("Boolean"),
            "header {\n  stamp {\n    sec: 0\n    nsec: 0\n  }\n  # data { ... }  (any number of them)\n}\n"
            "data: false\n");
  EXPECT_TRUE(messageTemplate("EntityFactory")->find("# sdf: \"\"  (at most one for from)\n") != std::string::npos);
}

TEST(MessageTemplate, IsAMessageOfItsType) {
  for (const std::string& type : messageTypes()) {
    const std::optional<std::string> text = messageTemplate(type);
    ASSERT_TRUE(text) << type;
    const MessagePointer message = newMessage(type);
    const std::optional<MessageError> error = parseMessage(*text, *message);
    EXPECT_FALSE(error) << type << ": " << error->message << "\n" << *text;
  }
}

TEST(MessageTemplate, IsNotThereForAnUnknownType) { EXPECT_EQ(messageTemplate("Tim"), std::nullopt); }

}  // namespace
}  // namespace pongsim::msgs
