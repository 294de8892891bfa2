#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// An XML element with its children and the positions of all parts. Systems read their parameters from the element of
/// their `<plugin>`.
class PONGSIM_API Element {
 public:
  struct Attribute {
    std::string name;
    std::string value;
    SourcePosition position;
    bool operator==(const Attribute&) const = default;
  };

  std::string name;
  /// The element's own text, trimmed.
  std::string text;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  SourcePosition position;

  /// @return The first child with that name, or null.
  const Element* child(std::string_view childName) const;

  /// @return All children with that name, in the order of the file.
  std::vector<const Element*> childrenNamed(std::string_view childName) const;

  /// @return The attribute with that name, or null.
  const Attribute* attribute(std::string_view attributeName) const;

  /// @return The attribute's value, or `fallback` without one.
  std::string attributeOr(std::string_view attributeName, std::string_view fallback) const;

  /// Reads this element's text as a T: double (also "inf", "-inf", "nan"), bool ("true", "false", "1", "0"), int,
  /// std::string, Vector3 (three numbers).
  /// @throws Error with the position if the text is not a T.
  template <class T>
  T as() const;

  /// Reads the text of the first child with that name.
  /// @return Its value; nothing if there is no such child or it is empty.
  /// @throws Error like `as()`.
  template <class T>
  std::optional<T> find(std::string_view childName) const {
    const Element* found = child(childName);
    if (found == nullptr || found->text.empty()) return std::nullopt;
    return found->as<T>();
  }

  /// Like `find`, with a default.
  template <class T>
  T get(std::string_view childName, T fallback) const {
    return find<T>(childName).value_or(std::move(fallback));
  }

  bool operator==(const Element&) const = default;
};

template <>
PONGSIM_API double Element::as<double>() const;
template <>
PONGSIM_API bool Element::as<bool>() const;
template <>
PONGSIM_API int Element::as<int>() const;
template <>
PONGSIM_API std::string Element::as<std::string>() const;
template <>
PONGSIM_API Vector3 Element::as<Vector3>() const;

}  // namespace pongsim
