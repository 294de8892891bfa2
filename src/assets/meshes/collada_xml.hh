#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::assets {

/// @throws std::runtime_error with the element's line and name.
[[noreturn]] void refuseElement(const tinyxml2::XMLElement& element, const std::string& reason);

/// @return Empty if the element has no such attribute.
std::string_view attributeOf(const tinyxml2::XMLElement& element, const char* name);

/// @return The name in an attribute of the form "#NAME"; empty if there is none.
std::string_view referenceIn(const tinyxml2::XMLElement& element, const char* name);

/// @return The element's first text, which is all that Assimp reads.
std::string_view textOf(const tinyxml2::XMLElement& element);

/// @return A whole number that isn't negative; `otherwise` if the element has no such attribute.
/// @throws std::runtime_error
std::uint64_t numberIn(const tinyxml2::XMLElement& element, const char* name, std::uint64_t otherwise);

/// @return The whole numbers in an element's text.
/// @throws std::runtime_error
std::vector<std::int32_t> numbersIn(const tinyxml2::XMLElement& element);

/// Calls `visit` with each element inside another one, in the order of the text. The depth is limited by the parser.
template <class Visit>
void forEachInside(const tinyxml2::XMLElement& outer, const Visit& visit) {
  for (const auto* child = outer.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    visit(*child);
    forEachInside(*child, visit);
  }
}

/// Calls `visit` with each child of that name.
template <class Visit>
void forEachChild(const tinyxml2::XMLElement& parent, const char* name, const Visit& visit) {
  for (const auto* child = parent.FirstChildElement(name); child != nullptr; child = child->NextSiblingElement(name)) {
    visit(*child);
  }
}

}  // namespace pongsim::assets
