#pragma once

#include <pybind11/pybind11.h>

#include "core/life.hh"
#include "pongsim/handles.hh"

namespace pongsim::python {

using PyModel = Handle<Model>;
using PyLink = Handle<Link>;
using PyJoint = Handle<Joint>;

/// Binds models, links and joints.
void bindHandles(py::module_& module);

}  // namespace pongsim::python
