#include "ros2/robot/kinematic_tree.hh"

#include <algorithm>

namespace pongsim::ros2 {

std::optional<std::size_t> KinematicTree::find(std::string_view frame) const {
  const auto found = std::ranges::find(links, frame, &TreeLink::frame);
  if (found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

std::optional<std::size_t> KinematicTree::find(LinkId id) const {
  const auto found =
      std::ranges::find_if(links, [id](const TreeLink& each) { return each.link && each.link->id() == id; });
  if (found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

Pose KinematicTree::rootPose(const Model& model) const {
  if (links.empty()) return {};
  const TreeLink& root = links.front();
  if (root.link) return root.link->pose();
  // a URDF root link named "world" is at the model's pose; any other root without a link is the world itself
  return model.urdf() != nullptr ? model.pose() : Pose();
}

Pose KinematicTree::poseInParent(std::size_t index, const Model& model) const {
  const TreeLink& link = links[index];
  switch (link.motion) {
    case Motion::kFixed:
      return link.X_ParentLink;
    case Motion::kTurning: {
      const double angle = link.source ? link.source->position(link.sourceAxis) : 0;
      return link.X_ParentLink * Pose{Vector3::Zero(), rotationAbout(link.axis, angle)};
    }
    case Motion::kSliding: {
      const double travel = link.source ? link.source->position(link.sourceAxis) : 0;
      return link.X_ParentLink * Pose{travel * link.axis, Quaternion::Identity()};
    }
    case Motion::kFree:
      if (!link.link) return link.X_ParentLink;
      return (rootPose(model) * poseInRoot(link.parent, model)).inverse() * link.link->pose();
  }
  return link.X_ParentLink;
}

Pose KinematicTree::poseInRoot(std::size_t index, const Model& model) const {
  Pose X_LinkBelow;
  for (; index != TreeLink::kNone && links[index].parent != TreeLink::kNone; index = links[index].parent) {
    X_LinkBelow = poseInParent(index, model) * X_LinkBelow;
  }
  return X_LinkBelow;
}

}  // namespace pongsim::ros2
