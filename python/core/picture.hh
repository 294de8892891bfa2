#pragma once

#include <pybind11/pybind11.h>

namespace pongsim::python {

/// Adds what draws a world from a place, without a camera in it. After the simulation, whose Python objects it takes.
void bindPictures(pybind11::module_& module);

}  // namespace pongsim::python
