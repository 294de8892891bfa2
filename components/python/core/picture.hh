#pragma once

#include <pybind11/pybind11.h>

namespace pongsim::python {

/// Binds functions that draw a world from any viewpoint, without a camera in it. Call after binding the simulation,
/// whose Python types it uses.
void bindPictures(pybind11::module_& module);

}  // namespace pongsim::python
