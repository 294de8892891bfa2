#include "pose_topic.hh"

#include "pongsim/messages/fields.hh"

namespace pongsim {

void PoseTopic::tellOf(const World& world, bool isMoving) {
  models_.clear();
  links_.clear();
  message_.Clear();
  for (const Model& model : world.models()) addModel(model, isMoving);
  for (const Model& model : models_) {
    for (const Link& link : model.links()) links_.push_back(link);
  }
  for (const Model& model : models_) add(model.name(), model.id().value);
  for (const Link& link : links_) add(link.name(), link.id().value);
  if (isMoving) return;
  for (const Link& link : links_) {
    for (const Visual& visual : link.visuals()) {
      setPose(visual.poseInLink(), add(visual.name(), visual.id().value));
    }
  }
  for (const LightPlace& light : Scene(world).lights()) setPose(light.X_ParentLight, add(light.name, light.id.value));
}

void PoseTopic::addModel(const Model& model, bool isMoving) {
  if (!isMoving || !model.isStatic()) models_.push_back(model);
  for (const Model& inner : model.models()) addModel(inner, isMoving);
}

ignition::msgs::Pose& PoseTopic::add(std::string_view name, std::uint64_t id) {
  ignition::msgs::Pose& pose = *message_.add_pose();
  pose.set_name(std::string(name));
  pose.set_id(static_cast<std::uint32_t>(id));
  return pose;
}

void PoseTopic::publish(Time time) {
  if (!publisher_.hasSubscribers()) return;
  setStamp(time, *message_.mutable_header());
  int next = 0;
  for (const Model& model : models_) setPose(model.poseInParent(), *message_.mutable_pose(next++));
  for (const Link& link : links_) setPose(link.poseInModel(), *message_.mutable_pose(next++));
  publisher_.publish(message_);
}

}  // namespace pongsim
