#include "urdf/link_elements.hh"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/element_edit.hh"
#include "urdf/collision_names.hh"
#include "urdf/pose_element.hh"

namespace pongsim::urdf {

namespace {

/// @return "lidar_collision_1"
std::string nameInOwnLink(const Shape& part, std::string_view kind, std::size_t number) {
  const std::string name = (part.name.empty() ? part.ownLink : part.name) + '_' + std::string(kind);
  return number > 0 ? name + '_' + std::to_string(number) : name;
}

/// @return Fortress's name for a collision or visual: "base_fixed_joint_lump__lidar_collision_1".
std::string nameOf(const Shape& part, const Link& link, std::string_view kind, std::size_t number) {
  const std::string name = nameInOwnLink(part, kind, number);
  return name.starts_with(link.name) ? name : link.name + "_fixed_joint_lump__" + name;
}

/// @return The address of a mesh in SDF's form.
std::string addressOf(const std::string& file) {
  constexpr std::string_view kPackage = "package://";
  return file.starts_with(kPackage) ? "model://" + file.substr(kPackage.size()) : file;
}

void addGeometry(const Shape& part, Element& parent) {
  const SourcePosition& position = positionIn(*part.xml, "geometry");
  Element& geometry = base::addChild(parent, "geometry", position);
  if (const auto* box = dynamic_cast<const ::urdf::Box*>(part.geometry.get())) {
    base::addChild(base::addChild(geometry, "box", position), "size", position,
                   textOf(Vector3(box->dim.x, box->dim.y, box->dim.z)));
  } else if (const auto* cylinder = dynamic_cast<const ::urdf::Cylinder*>(part.geometry.get())) {
    Element& shape = base::addChild(geometry, "cylinder", position);
    base::addChild(shape, "length", position, textOf(cylinder->length));
    base::addChild(shape, "radius", position, textOf(cylinder->radius));
  } else if (const auto* sphere = dynamic_cast<const ::urdf::Sphere*>(part.geometry.get())) {
    base::addChild(base::addChild(geometry, "sphere", position), "radius", position, textOf(sphere->radius));
  } else if (const auto* mesh = dynamic_cast<const ::urdf::Mesh*>(part.geometry.get())) {
    Element& shape = base::addChild(geometry, "mesh", position);
    base::addChild(shape, "scale", position, textOf(Vector3(mesh->scale.x, mesh->scale.y, mesh->scale.z)));
    base::addChild(shape, "uri", position, addressOf(mesh->filename));
  }
}

/// Rounds to six decimals: urdfdom reads colours as floats.
double rounded(double channel) { return std::round(channel * 1e6) / 1e6; }

/// Adds the colour of a material, with Fortress's brightness, unless an extension sets another one.
void addColor(const ::urdf::Color& color, const SourcePosition& position, Element& visual) {
  Element& material = base::childOrNew(visual, "material", position);
  if (material.child("diffuse") != nullptr || material.child("ambient") != nullptr) return;
  std::string text;
  for (const float channel : {color.r, color.g, color.b})
    text += textOf(rounded(std::clamp(channel / 0.8, 0.0, 1.0))) + ' ';
  text += textOf(rounded(color.a));
  base::addChild(material, "diffuse", position, text);
  base::addChild(material, "ambient", position, text);
}

/// Adds the collisions and visuals of one link.
class ShapesWriter {
 public:
  ShapesWriter(const Link& target, const Extensions& extensions, Element& element)
      : target_(target), extensions_(extensions), element_(element) {}

  void addCollisions(const Link& source, const Pose& X_TargetSource) {
    std::size_t number = 0;
    for (const Shape& part : source.collisions) {
      Element& collision = addShape(part, "collision", collisionCount_++, X_TargetSource);
      extensions_.addToCollision(part.ownLink, collision);
      const std::string converted = collision.attributeOr("name", "");
      names_.add(part.ownLink, nameInOwnLink(part, "collision", number++), converted);
      if (!part.name.empty()) names_.add(part.ownLink, part.name, converted);
    }
  }
  void addVisuals(const Link& source, const Pose& X_TargetSource) {
    for (const Shape& part : source.visuals) {
      Element& visual = addShape(part, "visual", visualCount_++, X_TargetSource);
      extensions_.addToVisual(part.ownLink, visual);
      if (part.material != nullptr) addColor(part.material->color, positionIn(*part.xml, "material"), visual);
    }
  }
  /// Call it after `addCollisions`, which gives the collisions the names that sensors need.
  void addExtensions(const Link& source) {
    const std::size_t first = element_.children.size();
    extensions_.addToLink(source.name, element_);
    for (std::size_t i = first; i < element_.children.size(); ++i) {
      if (element_.children[i].name == "sensor") names_.replaceIn(element_.children[i], source.name);
    }
  }

 private:
  Element& addShape(const Shape& part, std::string_view kind, std::size_t number, const Pose& X_TargetSource) {
    Element& element = base::addChild(element_, kind, part.xml->position);
    base::setAttribute(element, "name", nameOf(part, target_, kind, number), part.xml->position);
    addPose(element, X_TargetSource * part.X_LinkShape, positionIn(*part.xml, "origin"));
    addGeometry(part, element);
    return element;
  }

  const Link& target_;
  const Extensions& extensions_;
  Element& element_;
  std::size_t collisionCount_ = 0;
  std::size_t visualCount_ = 0;
  CollisionNames names_;
};

void addInertial(const Inertial& inertial, Element& link) {
  const SourcePosition& position = inertial.position;
  Element& element = base::addChild(link, "inertial", position);
  addPose(element, {inertial.com, Quaternion::Identity()}, position);
  base::addChild(element, "mass", position, textOf(inertial.mass));
  Element& inertia = base::addChild(element, "inertia", position);
  const Matrix3& m = inertial.moments;
  base::addChild(inertia, "ixx", position, textOf(m(0, 0)));
  base::addChild(inertia, "ixy", position, textOf(m(0, 1)));
  base::addChild(inertia, "ixz", position, textOf(m(0, 2)));
  base::addChild(inertia, "iyy", position, textOf(m(1, 1)));
  base::addChild(inertia, "iyz", position, textOf(m(1, 2)));
  base::addChild(inertia, "izz", position, textOf(m(2, 2)));
}

}  // namespace

void addLink(const Robot& robot, const Link& link, const Extensions& extensions, Element& model) {
  Element& element = base::addChild(model, "link", link.xml->position);
  base::setAttribute(element, "name", link.name, link.xml->position);
  if (link.joint) {
    const SourcePosition& position = positionIn(*link.joint->xml, "origin");
    const auto type = link.joint->urdf->type;
    if (type == ::urdf::Joint::FLOATING || type == ::urdf::Joint::PLANAR) {
      const std::string& parent = robot.links[link.joint->parent].name;
      addPose(element, link.joint->X_ParentJoint, position, parent == "world" ? "__model__" : parent);
    } else {
      addPose(element, Pose(), position, link.joint->urdf->name);
    }
  }
  if (link.inertial) addInertial(*link.inertial, element);

  ShapesWriter shapes(link, extensions, element);
  shapes.addCollisions(link, Pose());
  for (const Lumped& lumped : link.lumped) shapes.addCollisions(robot.links[lumped.link], lumped.X_TargetLink);
  shapes.addVisuals(link, Pose());
  for (const Lumped& lumped : link.lumped) shapes.addVisuals(robot.links[lumped.link], lumped.X_TargetLink);
  shapes.addExtensions(link);
  for (const Lumped& lumped : link.lumped) shapes.addExtensions(robot.links[lumped.link]);
}

void addFrames(const Robot& robot, const Link& link, const Extensions& extensions, Element& model) {
  const std::string& parent = robot.links[link.joint->parent].name;
  const auto add = [&](const std::string& name, const std::string& attachedTo, const SourcePosition& position) {
    Element& frame = base::addChild(model, "frame", position);
    base::setAttribute(frame, "name", name, position);
    base::setAttribute(frame, "attached_to", attachedTo, position);
    if (attachedTo == parent) addPose(frame, link.joint->X_ParentJoint, positionIn(*link.joint->xml, "origin"));
  };
  // the robot's own elements need the names: libsdformat 12 has no such frames
  const std::string& joint = link.joint->urdf->name;
  const bool hasJointFrame = !extensions.namesInModel(joint);
  if (hasJointFrame) add(joint, parent, link.joint->xml->position);
  if (!extensions.namesInModel(link.name)) add(link.name, hasJointFrame ? joint : parent, link.xml->position);
}

}  // namespace pongsim::urdf
