#pragma once

#include <string>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim::base {

Element makeElement(std::string_view name, const SourcePosition& position, std::string text = {});

/// Adds a child.
/// @return The child; valid until the next one is added.
Element& addChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text = {});

/// @return The first child with this name, for changing it, or null.
Element* childOf(Element& parent, std::string_view name);

/// @return The first child with this name, added if missing.
Element& childOrNew(Element& parent, std::string_view name, const SourcePosition& position);

/// Adds a child, or replaces the text and position of the first one with this name.
void setChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text);

/// @return The attribute with this name, for changing it, or null.
Element::Attribute* attributeOf(Element& element, std::string_view name);

/// Adds an attribute, or replaces the value and position of the one with this name.
void setAttribute(Element& element, std::string_view name, std::string value, const SourcePosition& position);

/// @return The shortest text that reads as the same number.
std::string shortestText(double value);

}  // namespace pongsim::base
