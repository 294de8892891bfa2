#include "log/command/export_rows.hh"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "log/store/failure.hh"
#include "pongsim/message.hh"

namespace pongsim::log {
namespace {

const std::string kTwist = "ignition.msgs.Twist";

std::string bytesOf(const std::string& type, const std::string& text) {
  const MessagePointer message = newMessage(type);
  EXPECT_FALSE(parseMessage(text, *message));
  return message->SerializeAsString();
}

std::string failureOf(const Definition& definition, const std::string& type, const std::vector<std::string>& fields) {
  try {
    ExportRows(definition, "/t", type, fields, true);
  } catch (const Failure& failure) {
    return std::string(failure.what()) + "|" + failure.hint();
  }
  return "";
}

TEST(ExportRows, MakeATableOfChosenValues) {
  ExportRows rows(protobufDefinition(kTwist), "/t", kTwist, {"linear.x", "angular"}, true);
  EXPECT_EQ(rows.csvHeader(), "time_s,linear.x,angular\n");
  EXPECT_EQ(rows.row(1'500'000'000, bytesOf(kTwist, "linear {x: 0.25} angular {z: 2}")), "1.500000000,0.25,{z: 2}\n");
}

TEST(ExportRows, MakeATableOfAll) {
  ExportRows rows(protobufDefinition("ignition.msgs.Color"), "/t", "ignition.msgs.Color", {}, true);
  EXPECT_EQ(rows.csvHeader(), "time_s,header.stamp.sec,header.stamp.nsec,r,g,b,a\n");
  EXPECT_EQ(rows.row(0, bytesOf("ignition.msgs.Color", "r: 0.5 a: 1")), "0.000000000,0,0,0.5,0,0,1\n");
}

TEST(ExportRows, MakeLinesOfJson) {
  ExportRows whole(protobufDefinition(kTwist), "/t", kTwist, {}, false);
  const auto line = nlohmann::json::parse(whole.row(2'000'000'001, bytesOf(kTwist, "linear {x: 0.25}")));
  EXPECT_EQ(line, nlohmann::json::parse(
                      R"({"time_s": 2.000000001, "topic": "/t", "type": "ignition.msgs.Twist",
                          "message": {"linear": {"x": 0.25}}})"));
  ExportRows parts(protobufDefinition(kTwist), "/t", kTwist, {"linear.x", "linear.y", "angular"}, false);
  const auto values = nlohmann::json::parse(parts.row(0, bytesOf(kTwist, "linear {x: nan y: 3}")));
  EXPECT_EQ(values["linear.x"], "NaN");
  EXPECT_EQ(values["linear.y"], 3);
  EXPECT_EQ(values["angular"], "{}");
}

TEST(ExportRows, ReadTypesThatOnlyTheFileKnows) {
  Definition definition = protobufDefinition(kTwist);
  for (std::size_t at = 0; (at = definition.schema.find("ignition", at)) != std::string::npos; at += 8) {
    definition.schema.replace(at, 8, "unknown_");
  }
  ExportRows rows(definition, "/t", "unknown_.msgs.Twist", {"linear.x"}, true);
  EXPECT_EQ(rows.row(0, bytesOf(kTwist, "linear {x: 7}")), "0.000000000,7\n");
}

TEST(ExportRows, EndOnATypeThatHasFieldsWithoutEnd) {
  // each level has two of the next: 2^60 values
  google::protobuf::FileDescriptorSet set;
  auto& file = *set.add_file();
  file.set_name("a.proto");
  file.set_syntax("proto3");
  for (int i = 0; i < 60; ++i) {
    auto& type = *file.add_message_type();
    type.set_name("M" + std::to_string(i));
    for (int j = 1; j <= 2 && i < 59; ++j) {
      auto& field = *type.add_field();
      field.set_name("f" + std::to_string(j));
      field.set_number(j);
      field.set_label(google::protobuf::FieldDescriptorProto::LABEL_OPTIONAL);
      field.set_type(google::protobuf::FieldDescriptorProto::TYPE_MESSAGE);
      field.set_type_name(".M" + std::to_string(i + 1));
    }
  }
  ExportRows rows({"protobuf", set.SerializeAsString(), "protobuf"}, "/t", "M0", {}, true);
  EXPECT_EQ(rows.row(0, ""), "0.000000000\n");
}

TEST(ExportRows, SayWhatIsWrong) {
  EXPECT_EQ(failureOf(protobufDefinition(kTwist), kTwist, {"lineer.x"}),
            "field 'lineer' is not in ignition.msgs.Twist|did you mean 'linear'?");
  EXPECT_NE(failureOf({"", "", "protobuf"}, "some.Type", {}).find("'some.Type' is unknown"), std::string::npos);
  EXPECT_NE(failureOf({"protobuf", "rubbish", "protobuf"}, kTwist, {}).find("is damaged"), std::string::npos);
  EXPECT_NE(failureOf({"protobuf", "", "protobuf"}, kTwist, {}).find("lacks that type"), std::string::npos);
  EXPECT_NE(failureOf({"jsonschema", "{}", "json"}, kTwist, {}).find("encoding is 'json'"), std::string::npos);
  ExportRows rows(protobufDefinition(kTwist), "/t", kTwist, {}, true);
  EXPECT_THROW(rows.row(0, "\xff\xff\xff"), Failure);
}

TEST(ExportRows, QuoteWhatWouldBeSeveralValues) {
  EXPECT_EQ(csvValue("a b"), "a b");
  EXPECT_EQ(csvValue("a,\"b\""), "\"a,\"\"b\"\"\"");
}

}  // namespace
}  // namespace pongsim::log
