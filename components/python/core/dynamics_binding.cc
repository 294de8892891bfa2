#include "core/dynamics_binding.hh"

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/dynamics.hh"
#include "core/memory.hh"
#include "core/values.hh"

namespace pongsim::python {

namespace {

Dynamics dynamicsOf(Life& life, const Model& model) { return Dynamics(model, life.use().world().gravity()); }

/// @return A new array of NumPy, with as many dimensions as `shape`.
py::object arrayOf(const Eigen::MatrixXd& matrix, const py::tuple& shape) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = matrix;
  auto memory = std::make_shared<Memory>(static_cast<std::size_t>(rows.size()) * sizeof(double), true);
  std::copy_n(rows.data(), rows.size(), reinterpret_cast<double*>(memory->bytes.data()));
  return py::module_::import("pongsim.arrays").attr("matrix")(memory, shape);
}

py::object massMatrix(PyModel& self) {
  const Eigen::MatrixXd M = dynamicsOf(*self.life, self.use()).massMatrix();
  return arrayOf(M, py::make_tuple(M.rows(), M.cols()));
}

py::object inverseDynamics(PyModel& self, const std::optional<std::vector<double>>& accelerations) {
  const Dynamics dynamics = dynamicsOf(*self.life, self.use());
  Eigen::VectorXd a = Eigen::VectorXd::Zero(dynamics.size());
  if (accelerations) {
    if (static_cast<Eigen::Index>(accelerations->size()) != a.size()) {
      throw py::value_error("model '" + self.inner.scopedName() + "' has " + std::to_string(a.size()) +
                            " velocities, not " + std::to_string(accelerations->size()));
    }
    std::ranges::copy(*accelerations, a.data());
    if (!a.allFinite()) throw py::value_error("accelerations must be finite");
  }
  return arrayOf(dynamics.inverseDynamics(a), py::make_tuple(a.size()));
}

py::object jacobian(PyLink& self, py::handle point) {
  Model top = self.use().model();
  while (const std::optional<Model> parent = top.parent()) top = *parent;
  const Eigen::MatrixXd J = dynamicsOf(*self.life, top).jacobian(self.inner, vectorOf(point, "a point"));
  return arrayOf(J, py::make_tuple(J.rows(), J.cols()));
}

}  // namespace

void bindDynamics(py::class_<PyModel>& model, py::class_<PyLink>& link) {
  model
      .def("mass_matrix", &massMatrix,
           "The mass matrix M of a top-level model at its present positions: n x n, for the n numbers that the model "
           "has in "
           "`Simulation.qvel`, in their order and units. So the kinetic energy is v M v / 2, and M dv/dt + h = f with "
           "`bias_forces` h and the forces f along v: for what is free, the force [N] and the torque about the origin "
           "of its "
           "frame [N m], in the world frame; for each axis its force [N m or N].\n\n"
           "Composite rigid body algorithm (Featherstone, Rigid Body Dynamics Algorithms, 2008, table 6.2). Raises "
           "ValueError for a nested model, and Refused for loops, ball, screw and gearbox joints, and joints to other "
           "models. Joints that a system has made at run time are not seen.")
      .def(
          "bias_forces", [](PyModel& self) { return inverseDynamics(self, std::nullopt); },
          "Forces h(q, v) of the present positions and velocities: Coriolis and centrifugal forces, and minus gravity, "
          "which acts on all links; n numbers, like the forces of `mass_matrix`. Damping, friction, springs and "
          "contacts "
          "are no part of it.")
      .def("inverse_dynamics", &inverseDynamics, py::arg("accelerations"),
           "The forces f = M a + h that give the model these accelerations: n numbers, like those of `mass_matrix`.\n\n"
           "accelerations: n numbers, dv/dt of the model's numbers in `Simulation.qvel`.\n"
           "Recursive Newton-Euler algorithm (Featherstone 2008, table 5.1). Raises ValueError for another number of "
           "them, "
           "and like `mass_matrix`.");
  link.def(
      "jacobian", &jacobian, py::arg("point") = py::make_tuple(0.0, 0.0, 0.0),
      "The Jacobian J of a point that moves with the link: 6 x n, with J v = the velocity of the point [m/s] and the "
      "angular velocity of the link [rad/s], both in the world frame, for the n numbers v that its top-level model has "
      "in `Simulation.qvel`. So J transposed takes a force at the point and a torque to forces along v.\n\n"
      "point: in the link frame [m].\n"
      "Raises Refused like `Model.mass_matrix`.");
}

}  // namespace pongsim::python
