#pragma once

#include <string>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim {

/// @return The value of a required attribute.
/// @throws Error at the element.
std::string requiredAttribute(const Element& element, std::string_view attribute);

/// @return The full name of the message type that an attribute names.
/// @throws Error at the element, with the most similar type name.
std::string typeAttribute(const Element& element, std::string_view attribute);

/// A topic and the type of its messages.
struct TypedName {
  std::string name;
  std::string type;
};

/// Reads the topic of an `<input>` or `<output>`.
/// @throws Error at the element.
TypedName typedName(const Element& element, std::string_view nameAttribute, std::string_view typeAttribute);

}  // namespace pongsim
