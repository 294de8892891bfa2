#include "core/properties.hh"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/errors.hh"
#include "core/values.hh"
#include "pongsim/geometry/shape.hh"
#include "pongsim/physical_properties.hh"
#include "pongsim/program/nearest_word.hh"
#include "pongsim/sensing/sensor.hh"

namespace pongsim::python {

namespace {

/// The kind of a shape in SDF, and its size: what SDF's elements say, in their order.
struct KindOf {
  py::tuple operator()(const NoShape&) const { return py::make_tuple("empty", py::tuple()); }
  py::tuple operator()(const BoxShape& shape) const { return py::make_tuple("box", tupleOf(shape.size)); }
  py::tuple operator()(const SphereShape& shape) const {
    return py::make_tuple("sphere", py::make_tuple(shape.radius));
  }
  py::tuple operator()(const CylinderShape& shape) const {
    return py::make_tuple("cylinder", py::make_tuple(shape.radius, shape.length));
  }
  py::tuple operator()(const CapsuleShape& shape) const {
    return py::make_tuple("capsule", py::make_tuple(shape.radius, shape.length));
  }
  py::tuple operator()(const EllipsoidShape& shape) const { return py::make_tuple("ellipsoid", tupleOf(shape.radii)); }
  py::tuple operator()(const PlaneShape& shape) const { return py::make_tuple("plane", tupleOf(shape.normal)); }
  py::tuple operator()(const TriangleShape& shape) const { return py::make_tuple("triangles", tupleOf(shape.scale)); }
};

PhysicalProperties properties(const std::shared_ptr<Life>& life) {
  return PhysicalProperties(life->edit("a change of a property").world());
}

py::tuple rowsOf(const Matrix3& matrix) {
  return py::make_tuple(tupleOf(matrix.row(0).transpose()), tupleOf(matrix.row(1).transpose()),
                        tupleOf(matrix.row(2).transpose()));
}

int knownAxis(const Joint& joint, int axis) {
  if (axis >= 0 && axis < joint.axisCount()) return axis;
  throw py::index_error("joint '" + std::string(joint.name()) + "' has no axis " + std::to_string(axis));
}

/// @param size A number, or several.
/// Raises TypeError.
std::vector<double> sizeFrom(py::handle size) {
  if (PyNumber_Check(size.ptr()) != 0 && PySequence_Check(size.ptr()) == 0) return {size.cast<double>()};
  try {
    return size.cast<std::vector<double>>();
  } catch (const py::cast_error&) {
    throw py::type_error("a size must be a number, or several in a tuple, not " +
                         std::string(py::str(py::type::of(size).attr("__name__"))));
  }
}

/// @return "link 'l' has no collision 'd'; did you mean 'c'?"
[[noreturn]] void raiseUnknown(const Link& link, const char* kind, const std::string& name,
                               const std::vector<std::string>& known) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string hint = didYouMean(name, words);
  throw py::key_error("link '" + link.scopedName() + "' has no " + kind + " '" + name + "'" +
                      (hint.empty() ? "" : "; " + hint));
}

std::vector<std::string> visualNames(const Link& link) {
  std::vector<std::string> names;
  for (const Visual& each : link.visuals()) names.push_back(each.name());
  return names;
}

Visual visualOf(const Link& link, const std::string& name) {
  for (const Visual& each : link.visuals()) {
    if (each.name() == name) return each;
  }
  raiseUnknown(link, "visual", name, visualNames(link));
}

py::tuple sizeTuple(const std::vector<double>& numbers) { return py::tuple(py::cast(numbers)); }

/// @return A pongsim.Noise.
py::object noiseOf(const NoiseSettings& noise) {
  const bool isOn = noise.type != NoiseSettings::Type::kNone;
  const NoiseSettings shown = isOn ? noise : NoiseSettings();
  const bool isRounded = noise.type == NoiseSettings::Type::kGaussianQuantized;
  return py::module_::import("pongsim.values")
      .attr("Noise")(shown.standardDeviation, shown.mean, shown.biasStandardDeviation, shown.biasMean,
                     shown.dynamicBiasStandardDeviation, shown.dynamicBiasCorrelationTime,
                     isRounded ? noise.precision : 0.0);
}

/// @param seven The numbers of a pongsim.Noise.
NoiseSettings noiseFrom(const std::array<double, 7>& seven) {
  using Type = NoiseSettings::Type;
  const bool isNone = std::ranges::all_of(seven, [](double number) { return number == 0; });
  NoiseSettings noise;
  noise.type = isNone ? Type::kNone : seven[6] != 0 ? Type::kGaussianQuantized : Type::kGaussian;
  noise.standardDeviation = seven[0];
  noise.mean = seven[1];
  noise.biasStandardDeviation = seven[2];
  noise.biasMean = seven[3];
  noise.dynamicBiasStandardDeviation = seven[4];
  noise.dynamicBiasCorrelationTime = seven[5];
  noise.precision = seven[6];
  return noise;
}

void setFriction(PyCollision& self, double friction, std::optional<double> friction2) {
  PhysicalProperties changes = properties(self.life);
  PhysicalProperties::Surface surface = changes.surface(self.inner);
  surface.friction = friction;
  surface.friction2 = friction2.value_or(friction);
  checkOutcome(changes.setSurface(self.inner, surface));
}

}  // namespace

void bindCollision(py::class_<PyCollision>& collision) {
  const auto surfaceOf = [](PyCollision& self) {
    const Collision& inner = self.use();
    return PhysicalProperties(self.life->use().world()).surface(inner);
  };
  collision
      .def_property_readonly(
          "scoped_name", [](PyCollision& self) { return self.use().scopedName(); },
          "Its name with its parents: \"model::link::collision\".")
      .def_property_readonly(
          "pose_in_link", [](PyCollision& self) { return poseOf(self.use().poseInLink()); },
          "Pose of its frame in the link frame.")
      .def_property_readonly(
          "shape", [](PyCollision& self) { return std::visit(KindOf(), self.use().shape())[0].cast<std::string>(); },
          "\"box\", \"sphere\", \"cylinder\", \"capsule\", \"ellipsoid\", \"plane\", \"triangles\" or \"empty\".")
      .def_property_readonly(
          "size", [](PyCollision& self) { return std::visit(KindOf(), self.use().shape())[1].cast<py::tuple>(); },
          "Its size [m]: a box's x, y, z; a radius; radius and length; an ellipsoid's radii; a plane's normal; the "
          "scale "
          "of triangles.")
      .def_property_readonly(
          "friction",
          [surfaceOf](PyCollision& self) {
            const auto surface = surfaceOf(self);
            return py::make_tuple(surface.friction, surface.friction2);
          },
          "Friction coefficients along both friction directions. Of two collisions, the smaller one counts.")
      .def_property_readonly(
          "restitution", [surfaceOf](PyCollision& self) { return surfaceOf(self).restitution; },
          "Coefficient of restitution, 0 to 1. Of two collisions, the product counts.")
      .def(
          "set_size",
          [](PyCollision& self, py::handle size, bool visuals, bool mass) {
            PhysicalProperties changes = properties(self.life);
            checkOutcome(changes.setSize(self.inner, sizeFrom(size), {.visuals = visuals, .mass = mass}));
          },
          py::arg("size"), py::kw_only(), py::arg("visuals") = true, py::arg("mass") = false,
          "Changes the size of a box, sphere, cylinder, capsule or ellipsoid, between two steps, until the world is "
          "reset. What is inside of something then is pushed out at 1 cm/s. Raises Refused.\n\n"
          "size: as `size` has it [m]; a radius may be a number.\n"
          "visuals: visuals of its link with the same shape, size and pose take the size, too.\n"
          "mass: the mass and inertia of its link follow at the same density; refused if the link has other collisions "
          "or if its centre of mass would move.")
      .def("set_friction", &setFriction, py::arg("friction"), py::arg("friction2") = py::none(),
           "Changes its friction coefficients, between two steps, until the world is reset. Raises Refused.\n\n"
           "friction2: along the second friction direction; None: the same.")
      .def(
          "set_restitution",
          [](PyCollision& self, double restitution) {
            PhysicalProperties changes = properties(self.life);
            PhysicalProperties::Surface surface = changes.surface(self.inner);
            surface.restitution = restitution;
            checkOutcome(changes.setSurface(self.inner, surface));
          },
          py::arg("restitution"),
          "Changes its coefficient of restitution, 0 to 1, between two steps, until the world is reset. Raises "
          "Refused.");
}

void bindProperties(py::class_<PyLink>& link) {
  link.def_property_readonly(
          "mass", [](PyLink& self) { return self.use().mass().mass; }, "Mass [kg].")
      .def_property_readonly(
          "center_of_mass", [](PyLink& self) { return tupleOf(self.use().mass().center); },
          "Centre of mass in the link frame [m].")
      .def_property_readonly(
          "inertia", [](PyLink& self) { return rowsOf(self.use().mass().inertia); },
          "Rows of the inertia tensor about the centre of mass, in the axes of the link frame [kg m^2].")
      .def(
          "set_mass",
          [](PyLink& self, double mass, std::optional<double> inertia) {
            PhysicalProperties changes = properties(self.life);
            const double factor = changes.inertiaFactor(self.inner);
            checkOutcome(changes.setMass(self.inner, mass, inertia.value_or(factor * mass / self.inner.mass().mass)));
          },
          py::arg("mass"), py::arg("inertia") = py::none(),
          "Changes its mass [kg], between two steps, until the world is reset; the centre of mass stays. Raises "
          "Refused "
          "if the link does not move.\n\n"
          "inertia: how many times the inertia of the file its inertia becomes; None: it grows like the mass.")
      .def_property_readonly(
          "inertia_factor",
          [](PyLink& self) {
            const Link& inner = self.use();
            return PhysicalProperties(self.life->use().world()).inertiaFactor(inner);
          },
          "How many times the inertia of the file its inertia is; 1 unless changed.")
      .def_property_readonly(
          "collisions",
          [](PyLink& self) {
            std::vector<PyCollision> collisions;
            for (const Collision& each : self.use().collisions()) collisions.push_back({self.life, each});
            return collisions;
          },
          "Its collisions, in the order of the file.")
      .def(
          "collision",
          [](PyLink& self, const std::string& name) {
            std::vector<std::string> names;
            for (const Collision& each : self.use().collisions()) {
              if (each.name() == name) return PyCollision{self.life, each};
              names.emplace_back(each.name());
            }
            raiseUnknown(self.inner, "collision", name, names);
          },
          py::arg("name"), "The collision with that name. Raises KeyError.")
      .def_property_readonly(
          "visual_names", [](PyLink& self) { return visualNames(self.use()); },
          "The names of its visuals, in the order of the file.")
      .def(
          "visual_size",
          [](PyLink& self, const std::string& visual) {
            const Visual found = visualOf(self.use(), visual);
            return sizeTuple(PhysicalProperties(self.life->use().world()).size(self.inner, found));
          },
          py::arg("visual"),
          "The size of a visual, as that of a collision; empty if it is no box, sphere, cylinder, capsule or "
          "ellipsoid. "
          "Raises KeyError.")
      .def(
          "set_visual_size",
          [](PyLink& self, const std::string& visual, py::handle size) {
            PhysicalProperties changes = properties(self.life);
            checkOutcome(changes.setSize(self.inner, visualOf(self.use(), visual), sizeFrom(size)));
          },
          py::arg("visual"), py::arg("size"),
          "Changes the size in which cameras and lidars see a visual, between two steps, until the world is reset. "
          "Raises KeyError and Refused.")
      .def(
          "set_color",
          [](PyLink& self, const std::string& visual, py::handle color) {
            PhysicalProperties changes = properties(self.life);
            checkOutcome(changes.setColor(visualOf(self.use(), visual).id(), vectorOf(color, "a colour")));
          },
          py::arg("visual"), py::arg("color"),
          "Changes the colour in which cameras and `Simulation.render` see a visual, until the world is reset; its "
          "textures "
          "are tinted with it. It is no part of saved states, and the page in a browser keeps that of the file. Raises "
          "KeyError and Refused.\n\n"
          "color: red, green, blue, 0 to 1, like `<diffuse>`.")
      .def_property_readonly(
          "sensor_names",
          [](PyLink& self) {
            std::vector<std::string> names;
            for (const Sensor& each : self.use().sensors()) names.push_back(each.scopedName());
            return names;
          },
          "The scoped names of its sensors.");
}

void bindProperties(py::class_<PyJoint>& joint) {
  joint
      .def(
          "axis",
          [](PyJoint& self, int axis) {
            const Joint& inner = self.use();
            const JointAxisInfo info = inner.axisInfo(knownAxis(inner, axis));
            return py::module_::import("pongsim.values")
                .attr("JointAxis")(tupleOf(info.xyz), info.lower, info.upper, info.effort, info.velocity, info.damping,
                                   inner.friction(axis));
          },
          py::arg("axis") = 0, "A JointAxis: its direction, limits, damping and friction.")
      .def_property_readonly(
          "parent",
          [](PyJoint& self) {
            const std::optional<Link> parent = self.use().parent();
            return parent ? std::optional(PyLink{self.life, *parent}) : std::nullopt;
          },
          "Its parent link; None: the world.")
      .def_property_readonly(
          "child",
          [](PyJoint& self) {
            return PyLink{self.life, self.use().child()};
          },
          "Its child link.")
      .def_property_readonly(
          "pose_in_parent", [](PyJoint& self) { return poseOf(self.use().poseInParent()); },
          "Pose of its frame in the frame of the parent, or of the world, with all axes at zero.")
      .def_property_readonly(
          "pose_in_child", [](PyJoint& self) { return poseOf(self.use().poseInChild()); },
          "Pose of its frame in the frame of the child.")
      .def(
          "set_damping",
          [](PyJoint& self, double damping, int axis) {
            checkOutcome(properties(self.life).setDamping(self.inner, damping, knownAxis(self.use(), axis)));
          },
          py::arg("damping"), py::arg("axis") = 0,
          "Changes the damping of the axis [N m s/rad or N s/m], between two steps, until the world is reset. Raises "
          "Refused.")
      .def(
          "set_friction",
          [](PyJoint& self, double friction, int axis) {
            checkOutcome(properties(self.life).setFriction(self.inner, friction, knownAxis(self.use(), axis)));
          },
          py::arg("friction"), py::arg("axis") = 0,
          "Changes the friction of the axis [N m or N], between two steps, until the world is reset. Raises Refused.");
}

void bindNoise(py::class_<PySensor>& sensor) {
  sensor
      .def_property_readonly(
          "noise",
          [](PySensor& self) {
            py::dict noises;
            const Sensor& inner = self.use();
            for (const auto& [value, noise] : PhysicalProperties(self.life->use().world()).noises(inner)) {
              noises[py::str(value)] = noiseOf(noise);
            }
            return noises;
          },
          "The noise of each value that it reads.")
      .def(
          "set_noise",
          [](PySensor& self, const std::string& value, const std::array<double, 7>& noise) {
            PhysicalProperties changes = properties(self.life);
            checkOutcome(changes.setNoise(self.inner, value, noiseFrom(noise)));
          },
          py::arg("value"), py::arg("noise"), "Changes the noise of a value. Raises Refused.");
}

}  // namespace pongsim::python
