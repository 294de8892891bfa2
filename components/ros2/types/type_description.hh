#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "ros2/types/bulk.hh"
#include "ros2/types/reflection.hh"

/// What a type is made of, as data. A type's hash and its definition follow from it by functions that are compiled
/// once, rather than once for every type.
namespace pongsim::ros2 {

struct TypeDescription;

/// The type of a field, as type_description_interfaces/msg/FieldType has it.
struct FieldType {
  /// The numbers of FieldType.msg.
  enum Id {
    kNested = 1,
    kInt8 = 2,
    kUint8 = 3,
    kInt16 = 4,
    kUint16 = 5,
    kInt32 = 6,
    kUint32 = 7,
    kInt64 = 8,
    kUint64 = 9,
    kFloat = 10,
    kDouble = 11,
    kBoolean = 15,
    kByte = 16,
    kString = 17,
    kBoundedString = 21
  };
  /// What FieldType.msg adds to the number of the elements' type.
  enum List { kNoList = 0, kArray = 48, kBoundedList = 96, kUnboundedList = 144 };

  /// In a list that of the elements.
  Id id;
  List list = kNoList;
  /// N of T[N] and T[<=N]; 0 for others.
  std::size_t capacity = 0;
  /// N of string<=N; 0 for others.
  std::size_t stringCapacity = 0;
  /// Describes the structure that it is; null for others.
  TypeDescription (*nested)() = nullptr;
};

/// A structure with its own fields, in the order of the wire: none for an empty type.
struct TypeDescription {
  struct Field {
    std::string name;
    FieldType type;
  };
  /// "geometry_msgs/msg/Twist"
  std::string name;
  std::vector<Field> fields;
};

template <Structure Type>
TypeDescription typeDescription();

namespace detail {

/// @return Of a type that is not a list.
template <class Type>
constexpr FieldType singleType() {
  if constexpr (Structure<Type>) return {.id = FieldType::kNested, .nested = typeDescription<Type>};
  if constexpr (std::is_same_v<Type, std::int8_t>) return {.id = FieldType::kInt8};
  if constexpr (std::is_same_v<Type, std::uint8_t>) return {.id = FieldType::kUint8};
  if constexpr (std::is_same_v<Type, std::int16_t>) return {.id = FieldType::kInt16};
  if constexpr (std::is_same_v<Type, std::uint16_t>) return {.id = FieldType::kUint16};
  if constexpr (std::is_same_v<Type, std::int32_t>) return {.id = FieldType::kInt32};
  if constexpr (std::is_same_v<Type, std::uint32_t>) return {.id = FieldType::kUint32};
  if constexpr (std::is_same_v<Type, std::int64_t>) return {.id = FieldType::kInt64};
  if constexpr (std::is_same_v<Type, std::uint64_t>) return {.id = FieldType::kUint64};
  if constexpr (std::is_same_v<Type, float>) return {.id = FieldType::kFloat};
  if constexpr (std::is_same_v<Type, double>) return {.id = FieldType::kDouble};
  if constexpr (std::is_same_v<Type, bool>) return {.id = FieldType::kBoolean};
  if constexpr (std::is_same_v<Type, std::byte>) return {.id = FieldType::kByte};
  if constexpr (Text<Type>) {
    return {.id = kBoundOf<Type> > 0 ? FieldType::kBoundedString : FieldType::kString,
            .stringCapacity = kBoundOf<Type>};
  }
}

template <class Type>
constexpr FieldType listOf(FieldType::List list, std::size_t capacity) {
  FieldType type = singleType<Type>();
  type.list = list;
  type.capacity = capacity;
  return type;
}

template <class Type>
constexpr FieldType fieldType() {
  if constexpr (std::is_same_v<Type, BulkBytes>) {
    return listOf<std::uint8_t>(FieldType::kUnboundedList, 0);
  } else if constexpr (kIsArray<Type>) {
    return listOf<typename Type::value_type>(FieldType::kArray, std::tuple_size_v<Type>);
  } else if constexpr (List<Type>) {
    return listOf<typename Type::value_type>(kBoundOf<Type> > 0 ? FieldType::kBoundedList : FieldType::kUnboundedList,
                                             kBoundOf<Type>);
  } else {
    return singleType<Type>();
  }
}
template <class Type>
inline constexpr FieldType kFieldType = fieldType<Type>();

/// Describes the fields that it is called with.
class FieldCollector {
 public:
  explicit FieldCollector(TypeDescription& type) : type_(type) {}
  template <class Field>
  void operator()(const char* name, const Field&) {
    add(name, kFieldType<Field>);
  }

 private:
  void add(const char* name, const FieldType& type);
  TypeDescription& type_;
};

}  // namespace detail

/// @return The description of a type; those of the structures in it are asked for from its fields.
template <Structure Type>
TypeDescription typeDescription() {
  TypeDescription description{nameOf<Type>(), {}};
  const Type value{};
  Type::visit(value, detail::FieldCollector(description));
  return description;
}

}  // namespace pongsim::ros2
