#pragma once

#include <algorithm>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// The frame of the model that a part stands in.
inline constexpr std::string_view kModelFrame = "__model__";

/// @return The attribute, to be changed; null where there is none of the name.
inline Element::Attribute* attributeOf(Element& element, std::string_view name) {
  const auto found = std::ranges::find(element.attributes, name, &Element::Attribute::name);
  return found != element.attributes.end() ? &*found : nullptr;
}

}  // namespace pongsim::sdf
