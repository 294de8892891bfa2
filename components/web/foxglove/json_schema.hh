#pragma once

#include <nlohmann/json.hpp>

namespace google::protobuf {
class Descriptor;
}

namespace pongsim::web::foxglove {

/// Describes the JSON of a message type as a JSON schema, as far as Foxglove reads one: types of fields, without
/// references. Where a type contains itself, the inner one is any object.
/// @return {"type": "object", "properties": {...}}, with the names of the fields in the .proto file.
nlohmann::json jsonSchema(const google::protobuf::Descriptor& type);

}  // namespace pongsim::web::foxglove
