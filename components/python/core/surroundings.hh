#pragma once

#include "core/life.hh"
#include "core/owner.hh"

namespace pongsim::python {

/// Binds contacts and rays.
void bindSurroundings(py::class_<Owner>& simulation);

}  // namespace pongsim::python
