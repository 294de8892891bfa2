#include "ros2/robot/urdf_writer.hh"

#include <ignition/msgs/scene.pb.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>

#include "pongsim/scene.hh"
#include "ros2/robot/urdf_shapes.hh"
#include "ros2/robot/xml_writer.hh"

namespace pongsim::ros2 {

namespace {

using VisualMessages = google::protobuf::RepeatedPtrField<ignition::msgs::Visual>;

class UrdfWriter {
 public:
  UrdfWriter(const World& world, const Model& model, const KinematicTree& tree) : model_(model), tree_(tree) {
    result_.warnings = tree.warnings;
    Scene(world).fillIn(scene_, [id = model.id().value](std::uint64_t candidate) { return candidate == id; });
    for (const auto& found : scene_.model()) collectVisuals(found);
  }

  UrdfText write() {
    xml_.open("robot").with("name", model_.name());
    for (const TreeLink& link : tree_.links) writeLink(link);
    for (const TreeLink& link : tree_.links) {
      if (link.parent != TreeLink::kNone) writeJoint(link);
    }
    result_.text = "<?xml version=\"1.0\"?>\n" + xml_.take();
    return std::move(result_);
  }

 private:
  void collectVisuals(const ignition::msgs::Model& model) {
    for (const auto& link : model.link()) visuals_[link.id()] = &link.visual();
    for (const auto& inner : model.model()) collectVisuals(inner);
  }

  void warn(const char* kind, const std::string& name, const TreeLink& link, const std::string& text) {
    if (!text.empty())
      result_.warnings.push_back(std::string(kind) + " '" + name + "' of '" + link.frame + "' " + text);
  }

  void writeLink(const TreeLink& link) {
    xml_.open("link").with("name", link.frame);
    if (link.link) {
      writeInertial(link.link->mass());
      const auto found = visuals_.find(static_cast<std::uint32_t>(link.link->id().value));
      if (found != visuals_.end()) {
        for (const auto& visual : *found->second) writeVisual(visual, link);
      }
      for (const Collision& collision : link.link->collisions()) writeCollision(collision, link);
    }
    xml_.close();
  }

  void writeInertial(const MassInfo& mass) {
    const Matrix3& inertia = mass.inertia;
    xml_.open("inertial").origin({mass.center, Quaternion::Identity()});
    xml_.open("mass").with("value", mass.mass).close();
    xml_.open("inertia").with("ixx", inertia(0, 0)).with("ixy", inertia(0, 1)).with("ixz", inertia(0, 2));
    xml_.with("iyy", inertia(1, 1)).with("iyz", inertia(1, 2)).with("izz", inertia(2, 2)).close();
    xml_.close();
  }

  static Pose poseOf(const ignition::msgs::Pose& pose) {
    const auto& rotation = pose.orientation();
    return {{pose.position().x(), pose.position().y(), pose.position().z()},
            {rotation.w(), rotation.x(), rotation.y(), rotation.z()}};
  }

  void writeVisual(const ignition::msgs::Visual& visual, const TreeLink& link) {
    std::string warning;
    const std::vector<UrdfShape> shapes = urdfShapesOf(visual.geometry(), warning);
    warn("visual", visual.name(), link, warning);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      xml_.open("visual").with("name", numbered(visual.name(), i));
      xml_.origin(poseOf(visual.pose()) * shapes[i].X_ShapePart);
      writeShape(shapes[i], xml_);
      if (visual.has_material()) writeMaterial(visual.material(), link.frame + "/" + visual.name());
      xml_.close();
    }
  }

  static std::string numbered(const std::string& name, std::size_t index) {
    return index == 0 ? name : name + "_" + std::to_string(index + 1);
  }

  void writeMaterial(const ignition::msgs::Material& material, const std::string& name) {
    const auto& color = material.diffuse();
    xml_.open("material").with("name", name);
    std::string rgba;
    for (const float share : {color.r(), color.g(), color.b(), color.a()}) {
      rgba += (rgba.empty() ? "" : " ") + numberOf(share);
    }
    xml_.open("color").with("rgba", rgba).close();
    const std::string& picture = material.pbr().albedo_map();
    if (picture.starts_with('/')) xml_.open("texture").with("filename", fileAddress(picture)).close();
    xml_.close();
  }

  /// @return A colour component clamped to 0 to 1, the range of URDF.
  static std::string numberOf(float share) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", std::isfinite(share) ? std::min(std::max(share, 0.0F), 1.0F) : 0.0F);
    return buffer;
  }

  void writeCollision(const Collision& collision, const TreeLink& link) {
    std::string warning;
    const std::vector<UrdfShape> shapes = urdfShapesOf(collision, warning);
    warn("collision", std::string(collision.name()), link, warning);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      xml_.open("collision").with("name", numbered(std::string(collision.name()), i));
      xml_.origin(collision.poseInLink() * shapes[i].X_ShapePart);
      writeShape(shapes[i], xml_);
      xml_.close();
    }
  }

  static const char* typeOf(const TreeLink& link, const JointAxisInfo& axis) {
    switch (link.motion) {
      case Motion::kFixed:
        return "fixed";
      case Motion::kTurning:
        return std::isinf(axis.lower) && std::isinf(axis.upper) ? "continuous" : "revolute";
      case Motion::kSliding:
        return "prismatic";
      case Motion::kFree:
        return "floating";
    }
    return "fixed";
  }

  void writeJoint(const TreeLink& link) {
    const JointAxisInfo axis = link.source ? link.source->axisInfo(link.sourceAxis) : JointAxisInfo();
    xml_.open("joint").with("name", link.joint).with("type", typeOf(link, axis));
    xml_.origin(link.X_ParentLink);
    xml_.open("parent").with("link", tree_.links[link.parent].frame).close();
    xml_.open("child").with("link", link.frame).close();
    if (link.source) {
      xml_.open("axis").with("xyz", link.axis).close();
      xml_.open("limit").with("lower", axis.lower).with("upper", axis.upper);
      xml_.with("effort", axis.effort).with("velocity", axis.velocity).close();
      xml_.open("dynamics").with("damping", axis.damping).with("friction", link.source->friction(link.sourceAxis));
      xml_.close();
    }
    xml_.close();
  }

  const Model& model_;
  const KinematicTree& tree_;
  ignition::msgs::Scene scene_;
  /// Keyed by link id.
  std::map<std::uint32_t, const VisualMessages*> visuals_;
  XmlWriter xml_;
  UrdfText result_;
};

}  // namespace

UrdfText writeUrdf(const World& world, const Model& model, const KinematicTree& tree) {
  return UrdfWriter(world, model, tree).write();
}

}  // namespace pongsim::ros2
