#pragma once

#include <pybind11/pybind11.h>

namespace pongsim::python {

/// Binds the simulation and the diagnostics of a file.
void bindSimulation(pybind11::module_& module);

}  // namespace pongsim::python
