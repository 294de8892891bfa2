#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// One XML element of a file, with all that stands below it and the position of each part. Systems find their
/// parameters in the one of their `<plugin>`.
class PONGSIM_API Element {
 public:
  struct Attribute {
    std::string name;
    std::string value;
    SourcePosition position;
    bool operator==(const Attribute&) const = default;
  };

  std::string name;
  /// The element's own text, without white space around it.
  std::string text;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  SourcePosition position;

  /// @return The first child of that name, or null.
  const Element* child(std::string_view childName) const;

  /// @return All children of that name, in the order of the file.
  std::vector<const Element*> childrenNamed(std::string_view childName) const;

  /// @return The attribute of that name, or null.
  const Attribute* attribute(std::string_view attributeName) const;

  /// @return The attribute's value, or `fallback` where there is none.
  std::string attributeOr(std::string_view attributeName, std::string_view fallback) const;

  /// Reads this element's text as a T: double (also "inf", "-inf", "nan"), bool ("true", "false", "1", "0"),
  /// int, std::string, Vector3 (three numbers).
  /// @throws Error naming the position where the text is not a T.
  template <class T>
  T as() const;

  /// Reads the text of the first child of that name.
  /// @return Its value, or nothing where there is no such child or its text is empty.
  /// @throws Error as `as()`.
  template <class T>
  std::optional<T> find(std::string_view childName) const {
    const Element* found = child(childName);
    if (found == nullptr || found->text.empty()) return std::nullopt;
    return found->as<T>();
  }

  /// As `find`, with a default.
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
