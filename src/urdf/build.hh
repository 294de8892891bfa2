#pragma once

#include <string>
#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::urdf {

Element makeElement(std::string_view name, const SourcePosition& position, std::string text = {});

/// Adds a child.
/// @return The child; valid until the next one is added.
Element& addChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text = {});

/// Adds a child, or replaces the text and position of the first one with this name.
void setChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text);

/// @return The first child with this name, created if missing.
Element& childOrNew(Element& parent, std::string_view name, const SourcePosition& position);

void setAttribute(Element& element, std::string_view name, std::string value, const SourcePosition& position);

/// Adds a `<pose>`, exact to the last bit.
void addPose(Element& parent, const Pose& pose, const SourcePosition& position, std::string_view relativeTo = {});

/// @return The shortest text that reads as the same number.
std::string textOf(double value);
std::string textOf(const Vector3& vector);

}  // namespace pongsim::urdf
