#include "ros2/types/type_hash.hh"

#include <map>
#include <string_view>

#include "ros2/types/sha256.hh"

namespace pongsim::ros2 {

namespace {

/// Descriptions keyed by type name: "{\"type_name\": ..., \"fields\": [...]}".
using Descriptions = std::map<std::string, std::string>;

/// One field, like the message type_description_interfaces/msg/FieldType.
std::string describeField(std::string_view name, const FieldType& type, std::string_view nested) {
  return "{\"name\": \"" + std::string(name) +
         "\", \"type\": {\"type_id\": " + std::to_string(int{type.list} + int{type.id}) +
         ", \"capacity\": " + std::to_string(type.capacity) +
         ", \"string_capacity\": " + std::to_string(type.stringCapacity) + ", \"nested_type_name\": \"" +
         std::string(nested) + "\"}}";
}

/// Adds the type and all types inside it.
void describe(const TypeDescription& type, Descriptions& all) {
  if (!all.try_emplace(type.name).second) return;
  std::string fields;
  for (const auto& [name, fieldType] : type.fields) {
    std::string nested;
    if (fieldType.nested != nullptr) {
      const TypeDescription inner = fieldType.nested();
      nested = inner.name;
      describe(inner, all);
    }
    if (!fields.empty()) fields += ", ";
    fields += describeField(name, fieldType, nested);
  }
  if (fields.empty()) fields = describeField(kFieldOfEmpty, {.id = FieldType::kUint8}, "");
  all[type.name] = "{\"type_name\": \"" + type.name + "\", \"fields\": [" + fields + "]}";
}

}  // namespace

std::string typeHash(const TypeDescription& type) {
  Descriptions all;
  describe(type, all);
  std::string others;
  for (const auto& [each, text] : all) {
    if (each == type.name) continue;
    if (!others.empty()) others += ", ";
    others += text;
  }
  return "RIHS01_" + sha256("{\"type_description\": " + all.at(type.name) + ", \"referenced_type_descriptions\": [" +
                            others + "]}");
}

}  // namespace pongsim::ros2
