#include <exception>
#include <map>
#include <set>
#include <utility>

#include "pongsim/element.hh"
#include "pongsim/files/urdf_source.hh"
#include "ros2/robot/kinematic_tree.hh"

namespace pongsim::ros2 {

namespace {

Vector3 vectorAttribute(const Element* element, std::string_view attribute, const Vector3& fallback) {
  if (element == nullptr || element->attribute(attribute) == nullptr) return fallback;
  // `Element` reads text, not attributes
  Element text;
  text.text = element->attribute(attribute)->value;
  try {
    return text.as<Vector3>();
  } catch (const std::exception&) {
    // the URDF loader accepts it
    return fallback;
  }
}

Pose originOf(const Element& part) {
  const Element* origin = part.child("origin");
  const Vector3 rpy = vectorAttribute(origin, "rpy", Vector3::Zero());
  return {vectorAttribute(origin, "xyz", Vector3::Zero()), fromRollPitchYaw(rpy.x(), rpy.y(), rpy.z())};
}

std::string linkOf(const Element& joint, std::string_view end) {
  const Element* element = joint.child(end);
  return element != nullptr ? element->attributeOr("link", "") : "";
}

Motion motionOf(const std::string& type) {
  if (type == "revolute" || type == "continuous") return Motion::kTurning;
  if (type == "prismatic") return Motion::kSliding;
  return type == "fixed" ? Motion::kFixed : Motion::kFree;
}

class UrdfTreeMaker {
 public:
  UrdfTreeMaker(const Model& model, const Frames& frames) : model_(model), frames_(frames) {
    for (const Element* joint : model.urdf()->robot.childrenNamed("joint")) {
      const std::string child = linkOf(*joint, "child");
      jointsBelow_[linkOf(*joint, "parent")].push_back(joint);
      children_.insert(child);
    }
  }

  KinematicTree make() {
    for (const Element* link : model_.urdf()->robot.childrenNamed("link")) {
      const std::string name = link->attributeOr("name", "");
      if (children_.contains(name)) continue;
      tree_.links.push_back({.frame = frames_.prefix + name, .link = model_.link(name)});
      waiting_.emplace_back(name, 0);
      while (!waiting_.empty()) addNext();
      break;
    }
    return std::move(tree_);
  }

 private:
  // the loader ensures that it is a tree, which may be very deep
  void addNext() {
    const auto [parentName, parent] = waiting_.back();
    waiting_.pop_back();
    for (const Element* joint : jointsBelow_[parentName]) {
      const std::string child = linkOf(*joint, "child");
      waiting_.emplace_back(child, tree_.links.size());
      tree_.links.push_back(linkBelow(*joint, child, parent));
    }
  }

  TreeLink linkBelow(const Element& joint, const std::string& child, std::size_t parent) const {
    TreeLink link{.frame = frames_.prefix + child,
                  .link = model_.link(child),
                  .parent = parent,
                  .joint = joint.attributeOr("name", ""),
                  .motion = motionOf(joint.attributeOr("type", "")),
                  .X_ParentLink = originOf(joint)};
    if (link.motion == Motion::kTurning || link.motion == Motion::kSliding) {
      link.axis = vectorAttribute(joint.child("axis"), "xyz", Vector3::UnitX()).normalized();
      link.source = model_.joint(link.joint);
      if (link.source && link.source->axisCount() == 0) link.source.reset();
    }
    return link;
  }

  const Model& model_;
  const Frames& frames_;
  std::map<std::string, std::vector<const Element*>> jointsBelow_;
  std::set<std::string> children_;
  /// Links whose children are added next.
  std::vector<std::pair<std::string, std::size_t>> waiting_;
  KinematicTree tree_;
};

}  // namespace

KinematicTree treeOfUrdf(const Model& model, const Frames& frames) { return UrdfTreeMaker(model, frames).make(); }

}  // namespace pongsim::ros2
