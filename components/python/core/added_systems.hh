#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "pongsim/element.hh"

namespace pongsim::python {

/// @param given `<plugin>` elements: a sequence of tuples of name, position, attributes and children. A position is a
/// tuple of file, line and column; an attribute of name, value and position; a child as an element.
/// @return The elements. Raises like a cast.
std::vector<Element> elementsFrom(const pybind11::handle& given);

}  // namespace pongsim::python
