#include "ros2/types/message_definition.hh"

#include <map>
#include <string_view>

namespace pongsim::ros2 {

namespace {

constexpr std::size_t kLineLength = 80;

/// The fields of types, one per line, keyed by type name.
using FieldLists = std::map<std::string, std::string>;

/// @return "std_msgs/Header" for "std_msgs/msg/Header", as in .msg files.
std::string nameInMsg(std::string_view name) {
  const std::size_t package = name.find('/'), last = name.rfind('/');
  return std::string(name.substr(0, package)) + std::string(name.substr(last));
}

/// @return The name of a type that is neither a list nor a structure.
std::string wordInMsg(const FieldType& type) {
  switch (type.id) {
    case FieldType::kNested:
      break;
    case FieldType::kInt8:
      return "int8";
    case FieldType::kUint8:
      return "uint8";
    case FieldType::kInt16:
      return "int16";
    case FieldType::kUint16:
      return "uint16";
    case FieldType::kInt32:
      return "int32";
    case FieldType::kUint32:
      return "uint32";
    case FieldType::kInt64:
      return "int64";
    case FieldType::kUint64:
      return "uint64";
    case FieldType::kFloat:
      return "float32";
    case FieldType::kDouble:
      return "float64";
    case FieldType::kBoolean:
      return "bool";
    case FieldType::kByte:
      return "byte";
    case FieldType::kString:
      return "string";
    case FieldType::kBoundedString:
      return "string<=" + std::to_string(type.stringCapacity);
  }
  return {};
}

/// @return Suffix of a list type, "[]", "[9]" or "[<=4]"; empty for other types.
std::string listInMsg(const FieldType& type) {
  switch (type.list) {
    case FieldType::kNoList:
      break;
    case FieldType::kArray:
      return "[" + std::to_string(type.capacity) + "]";
    case FieldType::kBoundedList:
      return "[<=" + std::to_string(type.capacity) + "]";
    case FieldType::kUnboundedList:
      return "[]";
  }
  return {};
}

/// Adds the type and all types inside it.
void listFields(const TypeDescription& type, FieldLists& all) {
  if (!all.try_emplace(type.name).second) return;
  std::string fields;
  for (const auto& [name, fieldType] : type.fields) {
    std::string word;
    if (fieldType.nested != nullptr) {
      const TypeDescription inner = fieldType.nested();
      word = nameInMsg(inner.name);
      listFields(inner, all);
    } else {
      word = wordInMsg(fieldType);
    }
    fields += word + listInMsg(fieldType) + " " + name + "\n";
  }
  all[type.name] = fields;
}

}  // namespace

std::string messageDefinition(const TypeDescription& type) {
  FieldLists all;
  listFields(type, all);
  std::string text = all.at(type.name);
  for (const auto& [each, fields] : all) {
    if (each == type.name) continue;
    text += std::string(kLineLength, '=') + "\nMSG: " + nameInMsg(each) + "\n" + fields;
  }
  return text;
}

}  // namespace pongsim::ros2
