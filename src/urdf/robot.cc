#include "urdf/robot.hh"

#include <string_view>
#include <unordered_map>
#include <utility>

#include "urdf/origin.hh"

namespace pongsim::urdf {

namespace {

std::optional<Inertial> inertialFrom(const ::urdf::Link& link, const Element& xml) {
  if (link.inertial == nullptr) return std::nullopt;
  const ::urdf::Inertial& given = *link.inertial;
  const Pose X_LinkCom = originOf(*xml.child("inertial"));
  Inertial inertial;
  inertial.mass = given.mass;
  inertial.com = X_LinkCom.position;
  inertial.moments << given.ixx, given.ixy, given.ixz, given.ixy, given.iyy, given.iyz, given.ixz, given.iyz, given.izz;
  if (!X_LinkCom.rotation.vec().isZero(0)) {
    const Matrix3 rotation = X_LinkCom.rotation.toRotationMatrix();
    inertial.moments = rotation * inertial.moments * rotation.transpose();
  }
  inertial.position = positionIn(xml, "inertial");
  return inertial;
}

/// urdfdom keeps collisions and visuals in the order of the file, so `xml` is the element with the same index.
template <class UrdfShape>
Shape shapeFrom(const UrdfShape& shape, const std::string& link, const Element* xml) {
  return {shape.name, link, xml, originOf(*xml), shape.geometry, nullptr};
}

Link linkFrom(const ::urdf::Link& given, const Element& xml) {
  Link link;
  link.name = given.name;
  link.xml = &xml;
  link.inertial = inertialFrom(given, xml);
  const std::vector<const Element*> collisions = xml.childrenNamed("collision");
  for (std::size_t i = 0; i < given.collision_array.size(); ++i) {
    link.collisions.push_back(shapeFrom(*given.collision_array[i], link.name, collisions.at(i)));
  }
  const std::vector<const Element*> visuals = xml.childrenNamed("visual");
  for (std::size_t i = 0; i < given.visual_array.size(); ++i) {
    link.visuals.push_back(shapeFrom(*given.visual_array[i], link.name, visuals.at(i)));
    link.visuals.back().material = given.visual_array[i]->material;
  }
  return link;
}

/// Elements of a robot by the attribute `name`.
using ElementsByName = std::unordered_map<std::string_view, const Element*>;

ElementsByName elementsNamed(const Element& robot, std::string_view kind) {
  ElementsByName parts;
  for (const Element& part : robot.children) {
    if (part.name == kind) parts.emplace(part.attribute("name")->value, &part);
  }
  return parts;
}

/// Copies the links of a tree, each before its descendants.
class TreeReader {
 public:
  TreeReader(const Element& xml, Robot& robot)
      : robot_(robot), links_(elementsNamed(xml, "link")), joints_(elementsNamed(xml, "joint")) {}

  void read(const ::urdf::Link& root) {
    // not recursive, because a chain of links may be long
    std::vector<PendingLink> stack{{&root, std::nullopt}};
    while (!stack.empty()) {
      const PendingLink next = stack.back();
      stack.pop_back();
      const std::size_t index = robot_.links.size();
      robot_.links.push_back(linkFrom(*next.link, *links_.at(next.link->name)));
      if (next.parent) robot_.links.back().joint = jointTo(*next.link, *next.parent);
      const auto& children = next.link->child_links;
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        stack.push_back({child->get(), index});
      }
    }
  }

 private:
  struct PendingLink {
    const ::urdf::Link* link;
    /// Index of the parent link; the root has none.
    std::optional<std::size_t> parent;
  };

  Joint jointTo(const ::urdf::Link& link, std::size_t parent) const {
    const ::urdf::JointSharedPtr& joint = link.parent_joint;
    const Element* xml = joints_.at(joint->name);
    return {xml, joint, parent, originOf(*xml)};
  }

  Robot& robot_;
  ElementsByName links_;
  ElementsByName joints_;
};

}  // namespace

Robot robotFrom(const ::urdf::ModelInterface& model, const Element& xml) {
  Robot robot;
  robot.xml = &xml;
  TreeReader(xml, robot).read(*model.getRoot());
  return robot;
}

const SourcePosition& positionIn(const Element& part, std::string_view child) {
  const Element* found = part.child(child);
  return found != nullptr ? found->position : part.position;
}

}  // namespace pongsim::urdf
