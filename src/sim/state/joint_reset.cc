#include "sim/state/joint_reset.hh"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "description/joint.hh"
#include "description/limits.hh"
#include "sim/edits/editor.hh"

namespace pongsim::sim {

namespace {

/// An axis of a joint at the current poses, in world coordinates.
struct WorldAxis {
  Vector3 direction;
  Vector3 origin;
  /// Translation per angle of a screw joint, `thread_pitch` / (2 pi) [m/rad]; else 0.
  double lead = 0;
  bool slides = false;
};

WorldAxis axisNow(const Access& access, const world::JointRecord& joint, std::size_t axis) {
  const description::Joint& description = *joint.description;
  const Pose X_WorldParent =
      joint.parentLink == world::kNoSlot ? Pose() : access.state.links[joint.parentLink].X_WorldLink;
  const Pose X_WorldChild =
      joint.childLink == world::kNoSlot ? Pose() : access.state.links[joint.childLink].X_WorldLink;
  // axis 0 is fixed to the parent, axis 1 to the child
  const Pose X_WorldParentJoint = X_WorldParent * description.X_ParentJoint;
  const Pose X_WorldChildJoint = X_WorldChild * description.X_ChildJoint;
  const Quaternion& rotation = axis == 0 ? X_WorldParentJoint.rotation : X_WorldChildJoint.rotation;
  const bool isScrew = description.type == description::JointType::kScrew;
  return {rotation * description.axes[axis].xyz, X_WorldChildJoint.position,
          isScrew ? description.threadPitch / (2 * std::numbers::pi) : 0,
          description.type == description::JointType::kPrismatic};
}

/// @return The joint's child, and all links that other joints connect to it, directly or through others; empty if these
/// joints form a loop, that is, also lead to the joint's parent or to the world.
std::vector<world::Slot> hangingOn(const world::Entities& entities, world::Slot joint) {
  const world::JointRecord& own = entities.joints()[joint];
  if (own.childLink == world::kNoSlot) return {};
  std::vector<bool> isFound(entities.links().size());
  std::vector<world::Slot> links = {own.childLink};
  isFound[own.childLink] = true;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (world::Slot slot = 0; slot < entities.joints().size(); ++slot) {
      const world::JointRecord& other = entities.joints()[slot];
      if (slot == joint || (other.parentLink != links[i] && other.childLink != links[i])) continue;
      const world::Slot next = other.parentLink == links[i] ? other.childLink : other.parentLink;
      if (next == world::kNoSlot || next == own.parentLink) return {};
      if (isFound[next]) continue;
      isFound[next] = true;
      links.push_back(next);
    }
  }
  return links;
}

std::string loopError(const world::JointRecord& joint) {
  return "joint '" + joint.description->name +
         "' can't be reset: other joints also connect its child to its parent or the world";
}

std::optional<std::string> valueFault(const world::JointRecord& joint, double value, double largest) {
  if (std::abs(value) <= largest) return std::nullopt;
  const std::string fault = std::isfinite(value) ? "too large" : "not finite";
  return "joint '" + joint.description->name + "' can't be reset to a value that is " + fault;
}

}  // namespace

Outcome<void> resetJointPosition(Access& access, world::Slot joint, std::size_t axis, double position) {
  const world::JointRecord& record = access.entities.joints()[joint];
  if (auto fault = valueFault(record, position, description::kLargestPosition)) return {*fault};
  const std::vector<world::Slot> links = hangingOn(access.entities, joint);
  if (links.empty()) return {loopError(record)};
  world::JointState& state = access.state.joints[joint];
  double& now = axis == 0 ? state.position : state.position2;
  const WorldAxis found = axisNow(access, record, axis);
  const double change = position - now;
  Pose X_NewOld;
  if (found.slides) {
    X_NewOld.position = change * found.direction;
  } else {
    X_NewOld.rotation = rotationAbout(found.direction, change);
    X_NewOld.position = found.origin - X_NewOld.rotation * found.origin + change * found.lead * found.direction;
  }
  Editor(access).move(links, X_NewOld, AfterMove::kKeepVelocity);
  access.engine.setJointPosition(joint, position, axis);
  now = position;
  return {};
}

Outcome<void> resetJointVelocity(Access& access, world::Slot joint, std::size_t axis, double velocity) {
  const world::JointRecord& record = access.entities.joints()[joint];
  if (auto fault = valueFault(record, velocity, description::kLargestVelocity)) return {*fault};
  const std::vector<world::Slot> links = hangingOn(access.entities, joint);
  if (links.empty()) return {loopError(record)};
  world::JointState& state = access.state.joints[joint];
  double& now = axis == 0 ? state.velocity : state.velocity2;
  const WorldAxis found = axisNow(access, record, axis);
  const Vector3 change = (velocity - now) * found.direction;
  for (const world::Slot slot : links) {
    world::LinkState& link = access.state.links[slot];
    if (found.slides) {
      link.v_WorldLink += change;
    } else {
      link.v_WorldLink += change.cross(link.X_WorldLink.position - found.origin) + found.lead * change;
      link.w_WorldLink += change;
    }
    access.engine.setLinkVelocity(slot, link.v_WorldLink, link.w_WorldLink);
  }
  now = velocity;
  return {};
}

}  // namespace pongsim::sim
