#pragma once

#include <algorithm>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Name of the enclosing model's frame.
inline constexpr std::string_view kModelFrame = "__model__";

/// @return The attribute, for changing it; null if there is none with this name.
inline Element::Attribute* attributeOf(Element& element, std::string_view name) {
  const auto found = std::ranges::find(element.attributes, name, &Element::Attribute::name);
  return found != element.attributes.end() ? &*found : nullptr;
}

}  // namespace pongsim::sdf
