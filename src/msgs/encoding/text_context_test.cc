#include "msgs/encoding/text_context.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <string>

#include "pongsim/message.hh"

namespace pongsim::msgs {
namespace {

/// The context at the text's end.
TextContext atEnd(const char* type, const std::string& text) {
  return contextOf(text, *newMessage(type)->GetDescriptor(), {0, static_cast<int>(text.size())});
}

TEST(TextContext, KnowsTheOpenMessageAndItsLastField) {
  const TextContext context = atEnd("Model", "name: 'm', link {name: 'l' pose: {position {x: ");
  ASSERT_NE(context.type, nullptr);
  EXPECT_EQ(context.type->full_name(), "ignition.msgs.Vector3d");
  ASSERT_NE(context.field, nullptr);
  EXPECT_EQ(context.field->name(), "x");
  EXPECT_EQ(context.opener, "position");
  EXPECT_EQ(context.lastName.column, 44);
}

TEST(TextContext, ComesBackFromClosedBraces) {
  const TextContext context = atEnd("Model", "link {name: 'l'} link <pose {}> visual [{name: 'a'}, {name: 'b'}] id: ");
  EXPECT_EQ(context.type->full_name(), "ignition.msgs.Model");
  EXPECT_EQ(context.field->name(), "id");
  EXPECT_EQ(context.opener, "");
}

TEST(TextContext, TakesNamesInValuesForValues) {
  const TextContext context = atEnd("Entity", "type: name ");
  EXPECT_EQ(context.field->name(), "type");
  EXPECT_EQ(context.lastValue.column, 6);
}

TEST(TextContext, GivesUpOnFieldsThatItDoesNotKnow) {
  const TextContext context = atEnd("Model", "nothing { inner { ");
  EXPECT_EQ(context.type, nullptr);
  EXPECT_EQ(context.field, nullptr);
  EXPECT_EQ(context.opener, "inner");
}

TEST(TextContext, SurvivesWhatIsNoText) {
  for (const char* text : {"}}}}", "]]]", "[[[", ":::", "{{{{", "\"", "'", "\\", "#", "- - -", "<<>>>>"}) {
    EXPECT_NE(atEnd("Model", std::string(text)).lastName.column, 1) << text;
  }
}

}  // namespace
}  // namespace pongsim::msgs
