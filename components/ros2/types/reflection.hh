#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// How to describe a ROS 2 type: a plain struct with a name and one function that lists its fields in order.
///
///     struct Quaternion {
///       static constexpr const char* kName = "geometry_msgs/msg/Quaternion";
///       double x = 0, y = 0, z = 0, w = 1;
///       static void visit(auto& self, auto&& field) {
///         field("x", self.x);
///         field("y", self.y);
///         field("z", self.z);
///         field("w", self.w);
///       }
///       bool operator==(const Quaternion&) const = default;
///     };
///
/// Reading and writing in CDR (cdr.hh) and a description of the type (type_description.hh) follow from that. Field
/// types are bool, the fixed-width integers, float, double, `std::byte` for `byte`, `std::uint8_t` for `char`,
/// `std::string`, `std::vector` for `T[]`, `std::array` for `T[N]`, `Bounded` for `T[<=N]` and `string<=N`, and other
/// such structs. A type with a composed name has `static std::string name()` instead of `kName`.
namespace pongsim::ros2 {

/// A string or list of at most N characters or elements.
template <class Container, std::size_t N>
struct Bounded : Container {
  using Container::Container;
  using Container::operator=;
  // implicit, so that a plain container converts to it
  Bounded(Container container) : Container(std::move(container)) {}
  static constexpr std::size_t kMost = N;
};
template <std::size_t N>
using BoundedString = Bounded<std::string, N>;
template <class Element, std::size_t N>
using BoundedList = Bounded<std::vector<Element>, N>;

template <class Type>
concept HasFixedName = requires {
  { Type::kName } -> std::convertible_to<std::string_view>;
};
template <class Type>
concept Structure = HasFixedName<Type> || requires {
  { Type::name() } -> std::convertible_to<std::string>;
};

/// @return "geometry_msgs/msg/Twist".
template <Structure Type>
std::string nameOf() {
  if constexpr (HasFixedName<Type>) {
    return Type::kName;
  } else {
    return Type::name();
  }
}

/// @return Whether the type has no fields. On the wire it then has a dummy field, as IDL requires.
template <Structure Type>
constexpr bool isEmpty() {
  return std::is_empty_v<Type>;
}
inline constexpr const char* kFieldOfEmpty = "structure_needs_at_least_one_member";

/// Calls `field(name, member)` with each field in wire order, including the dummy field of an empty type.
template <class Value, class Field>
void visitFields(Value& value, Field&& field) {
  using Type = std::remove_const_t<Value>;
  if constexpr (isEmpty<Type>()) {
    std::uint8_t nothing = 0;
    field(kFieldOfEmpty, nothing);
  } else {
    Type::visit(value, field);
  }
}

template <class Type>
inline constexpr bool kIsVector = false;
template <class Element>
inline constexpr bool kIsVector<std::vector<Element>> = true;
template <class Type>
inline constexpr bool kIsArray = false;
template <class Element, std::size_t N>
inline constexpr bool kIsArray<std::array<Element, N>> = true;
template <class Type>
inline constexpr std::size_t kBoundOf = 0;
template <class Container, std::size_t N>
inline constexpr std::size_t kBoundOf<Bounded<Container, N>> = N;

/// Types whose arrays have the same layout on the wire and in memory.
template <class Type>
concept Primitive = (std::is_arithmetic_v<Type> && !std::is_same_v<Type, bool>) || std::is_same_v<Type, std::byte>;
template <class Type>
concept Text = std::is_base_of_v<std::string, Type>;
template <class Type>
concept List = !Text<Type> && requires(Type& list) {
  typename Type::value_type;
  list.resize(1);
};

}  // namespace pongsim::ros2
