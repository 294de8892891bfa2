#include "core/handles.hh"

#include <pybind11/stl.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "core/dynamics_binding.hh"
#include "core/errors.hh"
#include "core/properties.hh"
#include "core/values.hh"
#include "pongsim/program/nearest_word.hh"

namespace pongsim::python {

namespace {

template <class Inner>
std::vector<Handle<Inner>> handles(const std::shared_ptr<Life>& life, std::vector<Inner> inner) {
  std::vector<Handle<Inner>> result;
  result.reserve(inner.size());
  for (Inner& each : inner) result.push_back({life, each});
  return result;
}

/// Raises KeyError for an unknown name, with the most similar one.
template <class Inner>
Handle<Inner> found(const std::shared_ptr<Life>& life, const std::optional<Inner>& inner, const Model& model,
                    const char* kind, const std::string& name, const std::vector<Inner>& others) {
  if (inner) return {life, *inner};
  std::vector<std::string_view> names;
  for (const Inner& other : others) names.push_back(other.name());
  const std::string hint = didYouMean(name, names);
  throw py::key_error("model '" + model.scopedName() + "' has no " + kind + " '" + name + "'" +
                      (hint.empty() ? "" : "; " + hint));
}

// larger commands have no effect: the same numbers as in `docs/physics.md` [N or N m], [m/s or rad/s]
constexpr double kMostForce = 1e10;
constexpr double kMostVelocity = 1e8;

double finite(double number, const char* what) {
  if (!std::isfinite(number)) throw py::value_error(std::string(what) + " must be finite");
  return number;
}

/// Raises ValueError for what is beyond a bound.
double within(double most, double number, const char* what) {
  if (std::abs(finite(number, what)) <= most) return number;
  std::ostringstream text;
  text << what << " must be at most " << most << ", not " << number;
  throw py::value_error(text.str());
}

Vector3 within(double most, py::handle three, const char* what) {
  const Vector3 vector = vectorOf(three, what);
  for (const double number : vector) within(most, number, what);
  return vector;
}

/// @return An existing axis of the joint.
int axisOf(const Joint& joint, int axis) {
  if (axis >= 0 && axis < joint.axisCount()) return axis;
  const int count = joint.axisCount();
  throw py::index_error("joint '" + std::string(joint.name()) + "' has " + std::to_string(count) +
                        (count == 1 ? " axis" : " axes") + " with a position; there is no axis " +
                        std::to_string(axis));
}

/// Raises Refused for what is static: a command to it would have no effect.
Model& moving(PyModel& self) {
  Model& model = self.use();
  if (model.isStatic()) raise("Refused", "model '" + model.scopedName() + "' is static");
  return model;
}

Link& moving(PyLink& self) {
  Link& link = self.use();
  if (link.model().isStatic()) raise("Refused", "link '" + link.scopedName() + "' is static");
  return link;
}

AfterMove afterMove(bool stop) { return stop ? AfterMove::kStop : AfterMove::kKeepVelocity; }

/// Base of all handles.
template <class PyHandle>
py::class_<PyHandle> bindCommon(py::module_& module, const char* name, const char* text) {
  return py::class_<PyHandle>(module, name, text)
      .def_property_readonly(
          "exists", [](PyHandle& self) { return !self.life->isClosed() && self.use().exists(); },
          "Whether it exists. If not, everything else but `id` raises Gone.")
      .def_property_readonly(
          "id", [](PyHandle& self) { return self.inner.id().value; }, "Its id, never reused in a run.")
      .def_property_readonly(
          "name", [](PyHandle& self) { return std::string(self.use().name()); },
          "Its own name, without those of its parents.")
      .def(
          "__eq__",
          [](PyHandle& self, py::object other) {
            if (!py::isinstance<PyHandle>(other)) return false;
            auto& that = other.cast<PyHandle&>();
            return self.life == that.life && self.inner.id() == that.inner.id();
          },
          py::arg("other"))
      .def("__hash__", [](PyHandle& self) { return std::hash<std::uint64_t>()(self.inner.id().value); })
      .def("__repr__", [name = std::string(name)](PyHandle& self) {
        const bool isThere = !self.life->isClosed() && !self.life->isStepping() && self.inner.exists();
        return "<pongsim." + name + " " +
               (isThere ? "'" + std::string(self.inner.name()) + "'" : std::string("(gone)")) + ">";
      });
}

void bindModel(py::class_<PyModel>& type) {
  type.def_property_readonly(
          "scoped_name", [](PyModel& self) { return self.use().scopedName(); },
          "Its name with its parent models: \"outer::inner\".")
      .def_property_readonly(
          "pose", [](PyModel& self) { return poseOf(self.use().pose()); },
          "Pose of the model frame in the world frame.")
      .def_property_readonly(
          "is_static", [](PyModel& self) { return self.use().isStatic(); }, "Whether it is static.")
      .def(
          "move",
          [](PyModel& self, py::handle pose, bool stop) {
            const Pose X_WorldModel = poseFrom(pose);
            checkOutcome(self.edit("a move").setPose(X_WorldModel, afterMove(stop)));
          },
          py::arg("pose"), py::kw_only(), py::arg("stop") = false,
          "Moves the model frame with all its links, between two steps.\n\n"
          "pose: a Pose, x y z, or x y z roll pitch yaw, in the world frame [m, rad].\n"
          "stop: set its velocity to zero; otherwise the velocity rotates with it, as in Fortress.\n"
          "Raises Refused if a joint connects it to something outside of it.")
      .def(
          "set_velocity",
          [](PyModel& self, py::handle linear, py::handle angular) {
            moving(self).setVelocity(within(kMostVelocity, linear, "a velocity"),
                                     within(kMostVelocity, angular, "an angular velocity"));
          },
          py::arg("linear"), py::arg("angular") = py::make_tuple(0.0, 0.0, 0.0),
          "Sets the velocity of the model frame's origin [m/s] and the angular velocity [rad/s], both in the world "
          "frame. "
          "All its links change their velocities accordingly; joint velocities stay.")
      .def_property_readonly(
          "links", [](PyModel& self) { return handles(self.life, self.use().links()); },
          "Its links, without nested ones.")
      .def_property_readonly(
          "joints", [](PyModel& self) { return handles(self.life, self.use().joints()); },
          "Its joints, without nested ones.")
      .def_property_readonly(
          "models", [](PyModel& self) { return handles(self.life, self.use().models()); }, "Its nested models.")
      .def(
          "link",
          [](PyModel& self, const std::string& name) {
            Model& model = self.use();
            return found<Link>(self.life, model.link(name), model, "link", name, model.links());
          },
          py::arg("name"), "The link with that name; in nested models \"inner::wheel\". Raises KeyError.")
      .def(
          "joint",
          [](PyModel& self, const std::string& name) {
            Model& model = self.use();
            return found<Joint>(self.life, model.joint(name), model, "joint", name, model.joints());
          },
          py::arg("name"), "The joint with that name; in nested models \"inner::hinge\". Raises KeyError.");
}

void bindLink(py::class_<PyLink>& type) {
  bindProperties(type);
  type.def_property_readonly(
          "scoped_name", [](PyLink& self) { return self.use().scopedName(); },
          "Its name with its models: \"model::link\".")
      .def_property_readonly(
          "model",
          [](PyLink& self) {
            return PyModel{self.life, self.use().model()};
          },
          "Its model.")
      .def_property_readonly(
          "pose", [](PyLink& self) { return poseOf(self.use().pose()); }, "Pose of the link frame in the world frame.")
      .def_property_readonly(
          "linear_velocity", [](PyLink& self) { return tupleOf(self.use().linearVelocity()); },
          "Velocity of the link frame's origin, world frame [m/s].")
      .def_property_readonly(
          "angular_velocity", [](PyLink& self) { return tupleOf(self.use().angularVelocity()); },
          "Angular velocity, world frame [rad/s].")
      .def(
          "add_wrench",
          [](PyLink& self, py::handle force, py::handle torque) {
            moving(self).addWrench(within(kMostForce, force, "a force"), within(kMostForce, torque, "a torque"));
          },
          py::arg("force"), py::arg("torque") = py::make_tuple(0.0, 0.0, 0.0),
          "Applies a force at the link frame's origin [N] and a torque [N m] during the next step, both in the world "
          "frame. Several calls add up. Raises Refused for a static link.")
      .def(
          "set_velocity",
          [](PyLink& self, py::handle linear, py::handle angular) {
            moving(self).setVelocity(within(kMostVelocity, linear, "a velocity"),
                                     within(kMostVelocity, angular, "an angular velocity"));
          },
          py::arg("linear"), py::arg("angular") = py::make_tuple(0.0, 0.0, 0.0),
          "Sets the velocity of the link frame's origin [m/s] and the angular velocity [rad/s], both in the world "
          "frame.");
}

void bindJoint(py::class_<PyJoint>& type) {
  bindProperties(type);
  type.def_property_readonly(
          "type", [](PyJoint& self) { return std::string(self.use().type()); }, "Its type in SDF: \"revolute\".")
      .def_property_readonly(
          "axis_count", [](PyJoint& self) { return self.use().axisCount(); },
          "Number of axes with a position: 0 for a fixed or ball joint, 1 or 2.")
      .def(
          "position", [](PyJoint& self, int axis) { return self.use().position(axisOf(self.inner, axis)); },
          py::arg("axis") = 0, "Position of the axis relative to the start, not wrapped [rad or m].")
      .def(
          "velocity", [](PyJoint& self, int axis) { return self.use().velocity(axisOf(self.inner, axis)); },
          py::arg("axis") = 0, "Velocity of the axis [rad/s or m/s].")
      .def(
          "drive",
          [](PyJoint& self, std::optional<double> velocity, int axis) {
            Joint& joint = self.use();
            if (velocity) {
              joint.setVelocityTarget(within(kMostVelocity, *velocity, "a velocity"), axisOf(joint, axis));
            } else {
              joint.clearVelocityTarget(axisOf(joint, axis));
            }
          },
          py::arg("velocity"), py::arg("axis") = 0,
          "Drives the axis at a velocity [rad/s or m/s] from the next step on, within its effort limit; 0 brakes; None "
          "ends it.")
      .def(
          "add_force",
          [](PyJoint& self, double force, int axis) {
            self.use().addForce(within(kMostForce, force, "a force"), axisOf(self.inner, axis));
          },
          py::arg("force"), py::arg("axis") = 0,
          "Applies a force along the axis [N m or N] during the next step. Several calls add up.")
      .def(
          "reset",
          [](PyJoint& self, std::optional<double> position, std::optional<double> velocity, int axis) {
            Joint& joint = self.edit("a joint's reset");
            if (position) checkOutcome(joint.resetPosition(finite(*position, "a position"), axisOf(joint, axis)));
            if (velocity) checkOutcome(joint.resetVelocity(finite(*velocity, "a velocity"), axisOf(joint, axis)));
          },
          py::arg("position") = py::none(), py::arg("velocity") = py::none(), py::arg("axis") = 0,
          "Sets position and velocity of the axis between two steps, and moves everything connected to the child. "
          "Raises Refused if other joints prevent that.");
}

}  // namespace

void bindHandles(py::module_& module) {
  // all classes before their functions, whose signatures name them
  auto model =
      bindCommon<PyModel>(module, "Model", "A model of a running world. Objects for the same model are equal.");
  auto link = bindCommon<PyLink>(module, "Link", "A link of a running world. Objects for the same link are equal.");
  auto joint = bindCommon<PyJoint>(
      module, "Joint",
      "A joint of a running world. Units are rad and N m for rotational axes, m and N for translational ones.");
  auto collision = bindCommon<PyCollision>(
      module, "Collision", "A collision of a link of a running world. Objects for the same collision are equal.");
  bindModel(model);
  bindLink(link);
  bindJoint(joint);
  bindCollision(collision);
  bindDynamics(model, link);
}

}  // namespace pongsim::python
