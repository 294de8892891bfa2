#include "ros2/services/named_poses.hh"

#include <algorithm>
#include <vector>

#include "ros2/services/entity_info.hh"
#include "ros2/services/result.hh"

namespace pongsim::ros2 {

namespace si = simulation_interfaces;

namespace {

std::vector<si::NamedPose> allPoses(const EntityFinder& finder) {
  std::vector<si::NamedPose> poses;
  const auto add = [&poses](std::string name, std::string description, const Pose& pose) {
    poses.push_back({std::move(name), std::move(description), {}, poseMessage(pose)});
  };
  for (const WorldFrame& frame : finder.world().frames()) add(frame.name, "frame of the world", frame.pose);
  for (const Model& model : finder.poses()) add(std::string(model.name()), "model without links", model.pose());
  return poses;
}

}  // namespace

si::srv::GetNamedPoses::Response namedPoses(const EntityFinder& finder, const si::TagsFilter& tags) {
  if (const auto error = filterError(tags)) return {failed(*error), {}};
  std::vector<si::NamedPose> poses = allPoses(finder);
  std::erase_if(poses, [&](const si::NamedPose& pose) { return !matches(tags, pose.tags); });
  return {succeeded(), std::move(poses)};
}

si::srv::GetNamedPoseBounds::Response namedPoseBounds(const EntityFinder& finder, const std::string& name) {
  const std::vector<si::NamedPose> poses = allPoses(finder);
  if (std::ranges::find(poses, name, &si::NamedPose::name) == poses.end()) {
    return {notFound("there is no named pose '" + name + "'"), {}};
  }
  return {succeeded(), {}};
}

}  // namespace pongsim::ros2
