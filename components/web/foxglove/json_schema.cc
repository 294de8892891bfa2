#include "web/foxglove/json_schema.hh"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <vector>

namespace pongsim::web::foxglove {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;

/// The types around a field, outermost first.
using Path = std::vector<const Descriptor*>;

json objectSchema(const Descriptor& type, Path& around);

json enumSchema(const google::protobuf::EnumDescriptor& type) {
  json names = json::array();
  for (int i = 0; i < type.value_count(); ++i) names.push_back(type.value(i)->name());
  return {{"type", "string"}, {"enum", std::move(names)}};
}

/// The schema of a field's value, or of one of its values if it has several.
json valueSchema(const FieldDescriptor& field, Path& around) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_BOOL:
      return {{"type", "boolean"}};
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_UINT32:
      return {{"type", "integer"}};
    case FieldDescriptor::CPPTYPE_FLOAT:
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return {{"type", "number"}};
    case FieldDescriptor::CPPTYPE_ENUM:
      return enumSchema(*field.enum_type());
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return objectSchema(*field.message_type(), around);
    // protobuf's JSON writes them as text, because numbers of JavaScript have 53 bits
    case FieldDescriptor::CPPTYPE_INT64:
    case FieldDescriptor::CPPTYPE_UINT64:
      return {{"type", "string"}};
    case FieldDescriptor::CPPTYPE_STRING:
      break;
  }
  json text = {{"type", "string"}};
  if (field.type() == FieldDescriptor::TYPE_BYTES) text["contentEncoding"] = "base64";
  return text;
}

json objectSchema(const Descriptor& type, Path& around) {
  json properties = json::object();
  if (std::ranges::find(around, &type) == around.end()) {
    around.push_back(&type);
    for (int i = 0; i < type.field_count(); ++i) {
      const FieldDescriptor& field = *type.field(i);
      json& schema = properties[field.name()];
      if (field.is_map()) {
        schema = {{"type", "object"}, {"properties", json::object()}};
      } else if (field.is_repeated()) {
        schema = {{"type", "array"}, {"items", valueSchema(field, around)}};
      } else {
        schema = valueSchema(field, around);
      }
    }
    around.pop_back();
  }
  return {{"type", "object"}, {"properties", std::move(properties)}};
}

}  // namespace

json jsonSchema(const Descriptor& type) {
  Path around;
  return objectSchema(type, around);
}

}  // namespace pongsim::web::foxglove
