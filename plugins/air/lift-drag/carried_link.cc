#include "carried_link.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace pongsim {

namespace {

// enough for a robot's longest arm, and a limit for closed loops
constexpr std::size_t kLongestChain = 32;

bool onlyTurns(const Joint& joint) {
  constexpr std::array<std::string_view, 6> kTypes{"revolute", "continuous", "fixed", "ball", "universal", "revolute2"};
  return std::ranges::find(kTypes, joint.type()) != kTypes.end();
}

/// @return The first joint in the file whose child is the link.
std::optional<Joint> carrierOf(const Link& link) {
  for (std::optional<Model> model = link.model(); model; model = model->parent()) {
    for (const Joint& joint : model->joints()) {
      if (joint.child().id() == link.id()) return joint;
    }
  }
  return std::nullopt;
}

}  // namespace

CarriedLink::CarriedLink(const Link& link) : link_(link), carrier_(link) {
  while (carrier_ && chain_.size() < kLongestChain) {
    const std::optional<Joint> joint = carrierOf(*carrier_);
    if (!joint || !onlyTurns(*joint)) return;
    chain_.push_back({*carrier_, joint->poseInChild().position});
    carrier_ = joint->parent();
  }
}

Vector3 CarriedLink::linearVelocity() const {
  if (chain_.empty()) return link_.linearVelocity();
  // velocity of a point that moves with the topmost link, or with the world
  Vector3 point = Vector3::Zero(), velocity = Vector3::Zero(), turning = Vector3::Zero();
  if (carrier_) {
    point = carrier_->pose().position;
    velocity = carrier_->linearVelocity();
    turning = carrier_->angularVelocity();
  }
  for (auto hold = chain_.rbegin(); hold != chain_.rend(); ++hold) {
    const Pose X_WorldChild = hold->child.pose();
    const Vector3 joint = X_WorldChild * hold->origin;
    velocity += turning.cross(joint - point);
    turning = hold->child.angularVelocity();
    velocity += turning.cross(X_WorldChild.position - joint);
    point = X_WorldChild.position;
  }
  return velocity;
}

}  // namespace pongsim
