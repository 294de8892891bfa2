#pragma once

#include "core/handles.hh"
#include "core/sensor.hh"

namespace pongsim::python {

using PyCollision = Handle<Collision>;

/// Binds what models, links and joints consist of, and what of it can be changed.
void bindCollision(py::class_<PyCollision>& collision);
void bindProperties(py::class_<PyLink>& link);
void bindProperties(py::class_<PyJoint>& joint);
void bindNoise(py::class_<PySensor>& sensor);

}  // namespace pongsim::python
