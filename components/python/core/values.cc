#include "core/values.hh"

#include <array>
#include <cmath>

#include "core/errors.hh"

namespace pongsim::python {

namespace {

template <std::size_t N>
std::array<double, N> numbers(const py::sequence& from, const char* what) {
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const py::object each = from[i];
    result[i] = PyFloat_AsDouble(each.ptr());
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    if (!std::isfinite(result[i])) throw py::value_error(std::string(what) + " has a number that is not finite");
  }
  return result;
}

py::sequence sequenceOf(py::handle from, const char* what, const char* wanted) {
  if (!PySequence_Check(from.ptr()) || PyUnicode_Check(from.ptr())) {
    throw py::type_error(std::string(what) + " must be " + wanted + ", not " + Py_TYPE(from.ptr())->tp_name);
  }
  return py::reinterpret_borrow<py::sequence>(from);
}

Vector3 vectorIn(const py::sequence& three, const char* what) {
  const auto [x, y, z] = numbers<3>(three, what);
  return {x, y, z};
}

}  // namespace

Vector3 vectorOf(py::handle three, const char* what) {
  const py::sequence sequence = sequenceOf(three, what, "three numbers");
  if (sequence.size() != 3) {
    throw py::value_error(std::string(what) + " must be three numbers, not " + std::to_string(sequence.size()));
  }
  return vectorIn(sequence, what);
}

py::object poseOf(const Pose& pose) {
  const Quaternion& rotation = pose.rotation;
  return py::module_::import("pongsim.values")
      .attr("Pose")(tupleOf(pose.position), py::make_tuple(rotation.x(), rotation.y(), rotation.z(), rotation.w()));
}

Pose poseFrom(py::handle from) {
  constexpr const char* kWanted = "a pongsim.Pose, x y z, or x y z roll pitch yaw";
  if (py::isinstance(from, py::module_::import("pongsim.values").attr("Pose"))) {
    const auto [x, y, z, w] = numbers<4>(from.attr("orientation").cast<py::sequence>(), "an orientation");
    const Quaternion rotation(w, x, y, z);
    if (std::abs(rotation.norm() - 1) > 1e-3) throw py::value_error("an orientation must be a quaternion of length 1");
    return {vectorOf(from.attr("position"), "a position"), rotation.normalized()};
  }
  const py::sequence sequence = sequenceOf(from, "a pose", kWanted);
  if (sequence.size() == 3) return {vectorIn(sequence, "a position"), Quaternion::Identity()};
  if (sequence.size() != 6) {
    throw py::value_error(std::string("a pose must be ") + kWanted + ", not " + std::to_string(sequence.size()) +
                          " numbers");
  }
  const auto [x, y, z, roll, pitch, yaw] = numbers<6>(sequence, "a pose");
  return {Vector3(x, y, z), fromRollPitchYaw(roll, pitch, yaw)};
}

Pose poseIn(std::span<const double> seven, const char* what) {
  for (const double number : seven) {
    if (!std::isfinite(number)) throw py::value_error("the pose of '" + std::string(what) + "' is not finite");
  }
  const Quaternion rotation(seven[6], seven[3], seven[4], seven[5]);
  if (std::abs(rotation.norm() - 1) > 1e-3) {
    throw py::value_error("the orientation of '" + std::string(what) + "' must be a quaternion of length 1");
  }
  return {Vector3(seven[0], seven[1], seven[2]), rotation.normalized()};
}

void checkOutcome(const Outcome<void>& outcome) {
  if (!outcome) raise("Refused", outcome.error);
}

}  // namespace pongsim::python
