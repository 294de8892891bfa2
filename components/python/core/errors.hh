#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"

namespace pongsim::python {

namespace py = pybind11;

/// @return An exception class of pongsim/errors.py.
py::object errorClass(const char* name);

/// Raises one of these.
[[noreturn]] void raise(const char* name, const std::string& text);

/// Raises a LoadError with all these diagnostics.
[[noreturn]] void raiseLoadError(const std::vector<Diagnostic>& found);

/// Issues a Python warning for each.
void warnOf(const std::vector<Diagnostic>& found);

/// @return "ValueError: too far (judge.py:12)".
std::string describe(const py::error_already_set& error);

/// Translates C++ exceptions into those of errors.py.
void translateErrors();

}  // namespace pongsim::python
