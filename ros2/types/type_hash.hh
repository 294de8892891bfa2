#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "ros2/types/bulk.hh"
#include "ros2/types/reflection.hh"

/// The hash by which Jazzy and later identify types (REP 2016): the SHA-256 of a JSON description of the type and of
/// all types inside it.
namespace pongsim::ros2 {

/// Descriptions keyed by type name: "{\"type_name\": ..., \"fields\": [...]}".
using Descriptions = std::map<std::string, std::string>;

namespace detail {

/// A field, as in the message type_description_interfaces/msg/FieldType.
std::string describeField(std::string_view name, int typeId, std::size_t capacity, std::size_t stringCapacity,
                          std::string_view nested);
std::string describeType(std::string_view name, const std::string& fields);
std::string hashOf(const std::string& name, const Descriptions& all);

/// @return The id of a type that is not a list (FieldType.msg).
template <class Type>
constexpr int singleTypeId() {
  if constexpr (Structure<Type>) return 1;
  if constexpr (std::is_same_v<Type, std::int8_t>) return 2;
  if constexpr (std::is_same_v<Type, std::uint8_t>) return 3;
  if constexpr (std::is_same_v<Type, std::int16_t>) return 4;
  if constexpr (std::is_same_v<Type, std::uint16_t>) return 5;
  if constexpr (std::is_same_v<Type, std::int32_t>) return 6;
  if constexpr (std::is_same_v<Type, std::uint32_t>) return 7;
  if constexpr (std::is_same_v<Type, std::int64_t>) return 8;
  if constexpr (std::is_same_v<Type, std::uint64_t>) return 9;
  if constexpr (std::is_same_v<Type, float>) return 10;
  if constexpr (std::is_same_v<Type, double>) return 11;
  if constexpr (std::is_same_v<Type, bool>) return 15;
  if constexpr (std::is_same_v<Type, std::byte>) return 16;
  if constexpr (Text<Type>) return kBoundOf<Type> > 0 ? 21 : 17;
}

/// Offsets added to the id for T[N], T[<=N] and T[].
inline constexpr int kArrayId = 48, kBoundedListId = 96, kListId = 144;

}  // namespace detail

/// Adds the type and all types inside it.
template <Structure Type>
void describe(Descriptions& all) {
  const std::string name = nameOf<Type>();
  if (all.contains(name)) return;
  all[name];
  std::string fields;
  Type value{};
  visitFields(value, [&]<class Field>(const char* field, Field&) {
    const auto add = [&]<class Single>(int list, std::size_t capacity, const Single*) {
      std::string nested;
      if constexpr (Structure<Single>) {
        nested = nameOf<Single>();
        describe<Single>(all);
      }
      if (!fields.empty()) fields += ", ";
      fields += detail::describeField(field, list + detail::singleTypeId<Single>(), capacity, kBoundOf<Single>, nested);
    };
    if constexpr (std::is_same_v<Field, BulkBytes>) {
      add(detail::kListId, 0, static_cast<const std::uint8_t*>(nullptr));
    } else if constexpr (kIsArray<Field>) {
      add(detail::kArrayId, Field().size(), static_cast<const typename Field::value_type*>(nullptr));
    } else if constexpr (List<Field>) {
      add(kBoundOf<Field> > 0 ? detail::kBoundedListId : detail::kListId, kBoundOf<Field>,
          static_cast<const typename Field::value_type*>(nullptr));
    } else {
      add(0, 0, static_cast<const Field*>(nullptr));
    }
  });
  all[name] = detail::describeType(name, fields);
}

/// @return "RIHS01_" and 64 digits.
template <Structure Type>
std::string typeHash() {
  Descriptions all;
  describe<Type>(all);
  return detail::hashOf(nameOf<Type>(), all);
}

}  // namespace pongsim::ros2
