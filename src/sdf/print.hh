#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// @return The element and all below it as a file of XML, two spaces a level.
std::string printDocument(const Element& root);

}  // namespace pongsim::sdf
