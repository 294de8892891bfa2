#pragma once

#include <pybind11/pybind11.h>

#include "core/handles.hh"

namespace pongsim::python {

/// Binds mass matrices, inverse dynamics and Jacobians.
void bindDynamics(py::class_<PyModel>& model, py::class_<PyLink>& link);

}  // namespace pongsim::python
