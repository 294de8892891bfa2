#include <utility>

#include "msgs/state/state_message.hh"
#include "pongsim/state/state_changes.hh"
#include "sim/api/access.hh"

namespace pongsim {

bool StateWatch::hasNews() const { return !hasTaken_ || changes_ != access_->changes; }

void StateWatch::take(StateSnapshot& snapshot) {
  const world::Entities& entities = access_->entities;
  const world::State& state = access_->state;
  snapshot.time = state.time;
  snapshot.everything.reset();
  if (hasNews()) {
    MessagePointer step = newMessage("ignition.msgs.SerializedStepMap");
    msgs::setState(entities, state, StateContent::kAll, false, *step);
    snapshot.everything = std::move(step);
    hasTaken_ = true;
    changes_ = access_->changes;
  }
  snapshot.places.clear();
  for (world::Slot slot = 0; slot < entities.models().size(); ++slot) {
    const world::ModelRecord& model = entities.models()[slot];
    // top-level static models can be moved by requests
    if (!model.isSetAside && (!model.isStatic || model.parent == world::kNoSlot))
      snapshot.places.push_back({model.id.value, world::poseInParent(entities, state, slot)});
  }
  for (world::Slot slot = 0; slot < entities.links().size(); ++slot) {
    const world::LinkRecord& link = entities.links()[slot];
    // the canonical link does not move within its model, whose pose is listed above
    if (link.isSetAside || link.isStatic || entities.models()[link.model].canonicalLink == slot) continue;
    snapshot.places.push_back({link.id.value, world::poseInModel(entities, state, slot)});
  }
  snapshot.joints.clear();
  for (world::Slot slot = 0; slot < entities.joints().size(); ++slot) {
    const std::size_t axes = entities.joints()[slot].description->axes.size();
    if (axes == 0 || entities.joints()[slot].isSetAside) continue;
    const world::JointState& joint = state.joints[slot];
    snapshot.joints.push_back({entities.joints()[slot].id.value, axes > 1 ? 2 : 1, {joint.position, joint.position2}});
  }
}

}  // namespace pongsim
