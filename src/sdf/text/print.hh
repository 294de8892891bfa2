#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// @return The element and everything below it as an XML file, indented by two spaces for each level.
std::string printDocument(const Element& root);

/// @return The content of the element in the same form, without the XML declaration.
std::string printChildren(const Element& element);

}  // namespace pongsim::sdf
