#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace pongsim::python {

/// Lets a function or the setter of a property say which argument is wrong, "name must be a text, not int", where
/// pybind11 lists the types of C++ that it would take. Call it before the docstring is rewritten.
/// @param name Of the function or the property.
void tellOfArguments(pybind11::handle function, const std::string& name);

}  // namespace pongsim::python
