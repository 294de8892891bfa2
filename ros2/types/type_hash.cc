#include "ros2/types/type_hash.hh"

#include "ros2/types/sha256.hh"

namespace pongsim::ros2::detail {

std::string describeField(std::string_view name, int typeId, std::size_t capacity, std::size_t stringCapacity,
                          std::string_view nested) {
  return "{\"name\": \"" + std::string(name) + "\", \"type\": {\"type_id\": " + std::to_string(typeId) +
         ", \"capacity\": " + std::to_string(capacity) + ", \"string_capacity\": " + std::to_string(stringCapacity) +
         ", \"nested_type_name\": \"" + std::string(nested) + "\"}}";
}

std::string describeType(std::string_view name, const std::string& fields) {
  return "{\"type_name\": \"" + std::string(name) + "\", \"fields\": [" + fields + "]}";
}

std::string hashOf(const std::string& name, const Descriptions& all) {
  std::string others;
  for (const auto& [each, text] : all) {
    if (each == name) continue;
    if (!others.empty()) others += ", ";
    others += text;
  }
  return "RIHS01_" +
         sha256("{\"type_description\": " + all.at(name) + ", \"referenced_type_descriptions\": [" + others + "]}");
}

}  // namespace pongsim::ros2::detail
