#include "web/typed/frames.hh"

#include "web/typed/parts.hh"

namespace pongsim::web::typed {

namespace {

constexpr const char* kWorld = "world";
constexpr const char* kWithin = "::";

}  // namespace

Frames::Frames(const ignition::msgs::Scene& scene) {
  for (const auto& model : scene.model()) add(model, {model.name(), kWorld});
}

void Frames::add(const ignition::msgs::Model& model, const Frame& frame) {
  moving_[model.id()] = frame;
  for (const auto& link : model.link()) {
    const Frame linkFrame{frame.name + kWithin + link.name(), frame.name};
    moving_[link.id()] = linkFrame;
    for (const auto& sensor : link.sensor()) {
      fixed_.push_back({{linkFrame.name + kWithin + sensor.name(), linkFrame.name}, sensor.pose()});
    }
  }
  for (const auto& nested : model.model()) add(nested, {frame.name + kWithin + nested.name(), frame.name});
}

::foxglove::FrameTransforms Frames::transforms(const ignition::msgs::Pose_V& poses, std::uint64_t timeNs) const {
  ::foxglove::FrameTransforms all;
  const auto add = [&](const Frame& frame, const ignition::msgs::Pose& pose) {
    auto& transform = *all.add_transforms();
    fillIn(poses.header(), timeNs, *transform.mutable_timestamp());
    transform.set_parent_frame_id(frame.parent);
    transform.set_child_frame_id(frame.name);
    fillIn(pose.position().x(), pose.position().y(), pose.position().z(), *transform.mutable_translation());
    fillIn(pose.orientation(), *transform.mutable_rotation());
  };
  for (const auto& pose : poses.pose()) {
    // other ids are visuals and lights, or were inserted later
    if (const auto found = moving_.find(pose.id()); found != moving_.end()) add(found->second, pose);
  }
  for (const Fixed& fixed : fixed_) add(fixed.frame, fixed.pose);
  return all;
}

}  // namespace pongsim::web::typed
