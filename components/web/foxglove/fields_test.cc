#include "web/foxglove/fields.hh"

#include <gtest/gtest.h>

namespace pongsim::web::foxglove {
namespace {

using nlohmann::json;

TEST(Fields, AreThereInTheirKindOnly) {
  const json object =
      json::parse(R"({"text": "a", "id": 7, "list": [1], "minus": -1, "large": 4294967296, "half": 0.5})");
  EXPECT_EQ(textField(object, "text"), "a");
  EXPECT_EQ(idField(object, "id"), 7U);
  EXPECT_EQ(listField(object, "list")->size(), 1U);
  for (const char* name : {"id", "list", "nothing"}) EXPECT_FALSE(textField(object, name)) << name;
  for (const char* name : {"text", "minus", "large", "half", "nothing"}) EXPECT_FALSE(idField(object, name)) << name;
  for (const char* name : {"text", "id", "nothing"}) EXPECT_FALSE(listField(object, name)) << name;
  EXPECT_FALSE(textField(json::array(), "text") || idField(json(3), "id") || listField(json(), "list"));
}

TEST(ParseJson, TakesWhatIsNotNestedTooDeep) {
  EXPECT_EQ(parseJson(R"({"a": ["[[\"", 1]})"), (json{{"a", {"[[\"", 1}}}));
  const std::string deep = std::string(64, '[') + std::string(64, ']');
  EXPECT_TRUE(parseJson(deep).is_array());
  EXPECT_TRUE(parseJson("[" + deep + "]").is_null());
  EXPECT_EQ(parseJson(R"({"a": ")" + std::string(100, '[') + "\"}").size(), 1U);
  for (const char* text : {"", "{", "]", "\"", "nonsense"}) EXPECT_TRUE(parseJson(text).is_null()) << text;
}

}  // namespace
}  // namespace pongsim::web::foxglove
