#include "log/playback/model_text.hh"

#include <ignition/msgs/axis.pb.h>
#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/inertial.pb.h>
#include <ignition/msgs/material.pb.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "log/playback/played_sdf.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

namespace im = ignition::msgs;

// sdf::JointType of sdformat 12, from 1
constexpr std::array<const char*, 9> kJointTypes{"ball",     "continuous", "fixed", "gearbox",  "prismatic",
                                                 "revolute", "revolute2",  "screw", "universal"};

constexpr int kMostNested = 100;

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '\'':
        result += "&apos;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

template <class... Numbers>
std::string numbers(Numbers... values) {
  std::string text;
  for (const double value : {static_cast<double>(values)...}) {
    char digits[32];
    if (!text.empty()) text += ' ';
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }
  return text;
}

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

/// @return The start tag of an element with a name.
std::string opening(const char* kind, const std::string& name, const std::string& more = {}) {
  return std::string("<") + kind + " name='" + escaped(name) + "'" + more + ">";
}

template <class M>
std::optional<M> messageOf(const RecordedState& state, std::uint64_t entity, const char* component) {
  const std::string* const bytes = state.find(entity, component);
  M message;
  if (bytes == nullptr || !message.ParseFromString(*bytes)) return std::nullopt;
  return message;
}

std::string vectorText(const im::Vector3d& v) { return numbers(v.x(), v.y(), v.z()); }

std::string geometryText(const im::Geometry& shape, const PlayedFiles& files) {
  switch (shape.type()) {
    case im::Geometry::BOX:
      return element("box", element("size", vectorText(shape.box().size())));
    case im::Geometry::SPHERE:
      return element("sphere", element("radius", numbers(shape.sphere().radius())));
    case im::Geometry::CYLINDER:
      return element("cylinder", element("radius", numbers(shape.cylinder().radius())) +
                                     element("length", numbers(shape.cylinder().length())));
    case im::Geometry::CONE:
      return element("cone", element("radius", numbers(shape.cone().radius())) +
                                 element("length", numbers(shape.cone().length())));
    case im::Geometry::CAPSULE:
      return element("capsule", element("radius", numbers(shape.capsule().radius())) +
                                    element("length", numbers(shape.capsule().length())));
    case im::Geometry::ELLIPSOID:
      return element("ellipsoid", element("radii", vectorText(shape.ellipsoid().radii())));
    case im::Geometry::PLANE:
      return element("plane", element("normal", vectorText(shape.plane().normal())) +
                                  element("size", numbers(shape.plane().size().x(), shape.plane().size().y())));
    case im::Geometry::MESH: {
      const im::MeshGeom& mesh = shape.mesh();
      std::string text = element("uri", escaped(files.placeOf(mesh.filename())));
      if (mesh.has_scale()) text += element("scale", vectorText(mesh.scale()));
      if (!mesh.submesh().empty()) {
        text += element("submesh", element("name", escaped(mesh.submesh())) +
                                       element("center", mesh.center_submesh() ? "true" : "false"));
      }
      return element("mesh", text);
    }
    default:
      return element("empty", "");
  }
}

std::string colorText(const char* name, const im::Color& color) {
  return element(name, numbers(color.r(), color.g(), color.b(), color.a()));
}

std::string materialText(const im::Material& material) {
  return element("material", colorText("ambient", material.ambient()) + colorText("diffuse", material.diffuse()) +
                                 colorText("specular", material.specular()) +
                                 colorText("emissive", material.emissive()));
}

std::string poseText(const RecordedState& state, std::uint64_t entity) {
  const std::string pose = state.text(entity, "Pose");
  return pose.empty() ? "" : element("pose", pose);
}

std::string inertialText(const im::Inertial& inertial) {
  const Quaternion rotation(inertial.pose().orientation().w(), inertial.pose().orientation().x(),
                            inertial.pose().orientation().y(), inertial.pose().orientation().z());
  const Vector3 angles = rollPitchYawOf(rotation.norm() > 0 ? rotation : Quaternion::Identity());
  return element(
      "inertial",
      element("pose", vectorText(inertial.pose().position()) + " " + numbers(angles.x(), angles.y(), angles.z())) +
          element("mass", numbers(inertial.mass())) +
          element("inertia", element("ixx", numbers(inertial.ixx())) + element("ixy", numbers(inertial.ixy())) +
                                 element("ixz", numbers(inertial.ixz())) + element("iyy", numbers(inertial.iyy())) +
                                 element("iyz", numbers(inertial.iyz())) + element("izz", numbers(inertial.izz()))));
}

std::string shapesText(const RecordedState& state, std::uint64_t link, const PlayedFiles& files) {
  std::string text;
  for (const auto& [component, kind] : {std::pair("Visual", "visual"), std::pair("Collision", "collision")}) {
    for (const std::uint64_t id : state.childrenWith(link, component)) {
      const auto shape = messageOf<im::Geometry>(state, id, "Geometry");
      const auto material = messageOf<im::Material>(state, id, "Material");
      text += opening(kind, state.text(id, "Name")) + poseText(state, id) +
              element("geometry", shape ? geometryText(*shape, files) : element("empty", "")) +
              (material ? materialText(*material) : "") + "</" + kind + ">";
    }
  }
  return text;
}

std::string jointText(const RecordedState& state, std::uint64_t joint) {
  const std::string number = state.text(joint, "JointType");
  std::size_t type = 0;
  std::from_chars(number.data(), number.data() + number.size(), type);
  if (type < 1 || type > kJointTypes.size()) return {};
  std::string text = opening("joint", state.text(joint, "Name"), " type='" + std::string(kJointTypes[type - 1]) + "'") +
                     poseText(state, joint) + element("parent", escaped(state.text(joint, "ParentLinkName"))) +
                     element("child", escaped(state.text(joint, "ChildLinkName")));
  for (const auto& [component, name] : {std::pair("JointAxis", "axis"), std::pair("JointAxis2", "axis2")}) {
    if (const auto axis = messageOf<im::Axis>(state, joint, component))
      text += element(name, element("xyz", vectorText(axis->xyz())));
  }
  return text + "</joint>";
}

/// @param depth Number of enclosing models.
/// @throws Failure if there are too many: in a damaged log models may contain themselves.
std::string composed(const RecordedState& state, std::uint64_t model, const PlayedFiles& files, int depth = 0) {
  if (depth > kMostNested) throw Failure("its models nest more than " + std::to_string(kMostNested) + " deep");
  std::string text = opening("model", state.text(model, "Name")) + poseText(state, model) +
                     element("static", state.text(model, "Static") == "1" ? "true" : "false");
  for (const std::uint64_t link : state.childrenWith(model, "Link")) {
    const auto inertial = messageOf<im::Inertial>(state, link, "Inertial");
    text += opening("link", state.text(link, "Name")) + poseText(state, link) +
            (inertial && inertial->mass() > 0 ? inertialText(*inertial) : "") + shapesText(state, link, files) +
            "</link>";
  }
  for (const std::uint64_t nested : state.childrenWith(model, "Model"))
    text += composed(state, nested, files, depth + 1);
  for (const std::uint64_t joint : state.childrenWith(model, "Joint")) text += jointText(state, joint);
  return text + "</model>";
}

}  // namespace

std::string modelText(const RecordedState& state, std::uint64_t model, const PlayedFiles& files) {
  const std::string* const whole = state.find(model, "ModelSdf");
  if (whole != nullptr && !whole->empty()) return playedSdf(*whole, files);
  return "<sdf version='1.9'>" + composed(state, model, files) + "</sdf>";
}

}  // namespace pongsim::log
