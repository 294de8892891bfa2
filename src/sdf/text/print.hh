#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// @return The element and all below it as a file of XML, two spaces a level.
std::string printDocument(const Element& root);

/// @return What stands in the element, in the same way, without a file's first line.
std::string printChildren(const Element& element);

}  // namespace pongsim::sdf
