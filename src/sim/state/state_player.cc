#include "pongsim/state/state_player.hh"

#include "sim/api/access.hh"

namespace pongsim {

Time StatePlayer::time() const { return access_->state.time; }
Time StatePlayer::stepSize() const { return access_->state.stepSize; }

void StatePlayer::place(const Link& link, const Pose& X_WorldLink) {
  const world::Slot slot = sim::slotOf(*access_, link.id());
  access_->state.links[slot] = {.X_WorldLink = X_WorldLink};
  access_->engine.setLinkPose(slot, X_WorldLink);
}

void StatePlayer::setAxis(const Joint& joint, int axis, double position, double velocity) {
  world::JointState& state = access_->state.joints[sim::slotOf(*access_, joint.id())];
  (axis == 0 ? state.position : state.position2) = position;
  (axis == 0 ? state.velocity : state.velocity2) = velocity;
}

}  // namespace pongsim
