#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <span>
#include <string>

#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim::python {

namespace py = pybind11;

/// @return (x, y, z)
inline py::tuple tupleOf(const Vector3& vector) { return py::make_tuple(vector.x(), vector.y(), vector.z()); }

/// @param what Its name in the message: "force".
/// Raises TypeError or ValueError unless it is three finite numbers.
Vector3 vectorOf(py::handle three, const char* what);

/// @param seven x, y, z [m] and a quaternion x, y, z, w.
/// Raises ValueError, which names `what`, unless the numbers are finite and the quaternion has length 1.
Pose poseIn(std::span<const double> seven, const char* what);

/// @return A pongsim.Pose.
py::object poseOf(const Pose& pose);

/// @param from A pongsim.Pose; x, y, z; or x, y, z, roll, pitch, yaw as in SDF.
Pose poseFrom(py::handle from);

/// Raises Refused if a change was refused.
void checkOutcome(const Outcome<void>& outcome);

}  // namespace pongsim::python
