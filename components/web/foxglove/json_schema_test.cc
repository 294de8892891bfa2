#include "web/foxglove/json_schema.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/model.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/serialized_map.pb.h>
#include <ignition/msgs/world_control.pb.h>

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;
using nlohmann::json;

template <class Message>
json schemaOf() {
  return jsonSchema(*Message::descriptor());
}

TEST(JsonSchema, DescribesFieldsAsTheJsonOfMessagesHasThem) {
  const json schema = schemaOf<im::WorldControl>();
  EXPECT_EQ(schema["type"], "object");
  const json& fields = schema["properties"];
  EXPECT_EQ(fields["pause"], (json{{"type", "boolean"}}));
  EXPECT_EQ(fields["multi_step"], (json{{"type", "integer"}}));
  EXPECT_EQ(fields["reset"]["properties"]["all"]["type"], "boolean");
  // 64 bits are text
  EXPECT_EQ(fields["header"]["properties"]["stamp"]["properties"]["sec"]["type"], "string");
  EXPECT_EQ(fields["header"]["properties"]["data"]["type"], "array");
  EXPECT_EQ(fields["header"]["properties"]["data"]["items"]["properties"]["key"]["type"], "string");
}

TEST(JsonSchema, NamesEnumsAndTheEncodingOfBytes) {
  const json fields = schemaOf<im::Image>()["properties"];
  EXPECT_EQ(fields["data"], (json{{"type", "string"}, {"contentEncoding", "base64"}}));
  EXPECT_EQ(fields["pixel_format_type"]["enum"][3], "RGB_INT8");
}

TEST(JsonSchema, HasMapsAsAnyObject) {
  const json fields = schemaOf<im::SerializedStateMap>()["properties"];
  EXPECT_EQ(fields["entities"], (json{{"type", "object"}, {"properties", json::object()}}));
}

TEST(JsonSchema, EndsWhereATypeContainsItself) {
  const json inner = schemaOf<im::Model>()["properties"]["model"]["items"];
  EXPECT_EQ(inner, (json{{"type", "object"}, {"properties", json::object()}}));
  // the largest type that a service of a world returns
  EXPECT_LT(schemaOf<im::Scene>().dump().size(), 200'000U);
}

}  // namespace
}  // namespace pongsim::web::foxglove
