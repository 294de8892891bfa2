#pragma once

#include <pybind11/pybind11.h>

namespace pongsim::python {

/// Adds the simulation and what it tells of a file.
void bindSimulation(pybind11::module_& module);

}  // namespace pongsim::python
