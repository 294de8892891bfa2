#pragma once

#include <map>
#include <string>
#include <string_view>

#include "ros2/types/bulk.hh"
#include "ros2/types/reflection.hh"

/// Message definitions in the .msg language, as stored in bags. They contain no comments, constants and defaults, which
/// are not needed for reading messages.
namespace pongsim::ros2 {

/// The fields of each type, one per line, keyed by type name.
using FieldLists = std::map<std::string, std::string>;

namespace detail {

/// @return The name as written in .msg files: "std_msgs/Header" for "std_msgs/msg/Header".
std::string nameInMsg(std::string_view name);

/// @return The fields of "geometry_msgs/Twist", followed by those of all other types with their names.
std::string joinFieldLists(const std::string& name, const FieldLists& all);

/// @return The .msg keyword for a type that is not a list.
template <class Type>
std::string wordInMsg() {
  if constexpr (Structure<Type>) return nameInMsg(nameOf<Type>());
  if constexpr (std::is_same_v<Type, bool>) return "bool";
  if constexpr (std::is_same_v<Type, std::byte>) return "byte";
  if constexpr (std::is_same_v<Type, float>) return "float32";
  if constexpr (std::is_same_v<Type, double>) return "float64";
  if constexpr (std::is_integral_v<Type> && !std::is_same_v<Type, bool>) {
    return (std::is_signed_v<Type> ? "int" : "uint") + std::to_string(8 * sizeof(Type));
  }
  if constexpr (Text<Type>) return kBoundOf<Type> > 0 ? "string<=" + std::to_string(kBoundOf<Type>) : "string";
}

}  // namespace detail

/// Adds the type and all types inside it.
template <Structure Type>
void listFields(FieldLists& all) {
  const std::string name = nameOf<Type>();
  if (all.contains(name)) return;
  all[name];
  std::string fields;
  Type value{};
  const auto add = [&]<class Single>(const char* field, const std::string& list, const Single*) {
    if constexpr (Structure<Single>) listFields<Single>(all);
    fields += detail::wordInMsg<Single>() + list + " " + field + "\n";
  };
  if (!isEmpty<Type>()) {
    Type::visit(value, [&]<class Field>(const char* field, Field&) {
      if constexpr (std::is_same_v<Field, BulkBytes>) {
        add(field, "[]", static_cast<const std::uint8_t*>(nullptr));
      } else if constexpr (kIsArray<Field>) {
        add(field, "[" + std::to_string(Field().size()) + "]", static_cast<const typename Field::value_type*>(nullptr));
      } else if constexpr (List<Field>) {
        add(field, kBoundOf<Field> > 0 ? "[<=" + std::to_string(kBoundOf<Field>) + "]" : "[]",
            static_cast<const typename Field::value_type*>(nullptr));
      } else {
        add(field, "", static_cast<const Field*>(nullptr));
      }
    });
  }
  all[name] = fields;
}

/// @return The type's fields, followed by those of all types inside it, in MCAP's "ros2msg" format
/// (https://mcap.dev/spec/registry).
template <Structure Type>
std::string messageDefinition() {
  FieldLists all;
  listFields<Type>(all);
  return detail::joinFieldLists(nameOf<Type>(), all);
}

}  // namespace pongsim::ros2
