#include "ros2/robot/robot_list.hh"

#include <algorithm>
#include <numbers>

#include "pongsim/files/urdf_source.hh"
#include "ros2/robot/frame_names.hh"

namespace pongsim::ros2 {

namespace {

/// Rotation of the optical frame of REP 103 (z ahead, x to the right) in a camera's frame (x ahead, z up).
const Pose kOptical{Vector3::Zero(), fromRollPitchYaw(-std::numbers::pi / 2, 0, -std::numbers::pi / 2)};

std::vector<Sensor> sensorsOf(const Model& model) {
  std::vector<Sensor> all;
  for (const Link& link : model.links()) {
    for (const Sensor& sensor : link.sensors()) all.push_back(sensor);
  }
  for (const Joint& joint : model.joints()) {
    for (const Sensor& sensor : joint.sensors()) all.push_back(sensor);
  }
  for (const Model& inner : model.models()) {
    for (const Sensor& sensor : sensorsOf(inner)) all.push_back(sensor);
  }
  return all;
}

/// @return The frames of the sensors that `isThere` does not accept, each once.
template <class IsThere, class FrameOf>
std::vector<SensorFrame> framesOf(const std::vector<Sensor>& sensors, const Frames& frames, const IsThere& isThere,
                                  const FrameOf& frameOf) {
  std::vector<SensorFrame> all;
  const auto add = [&](std::string name, const std::string& parent, const Pose& X_ParentFrame) {
    if (isThere(name) || std::ranges::find(all, name, &SensorFrame::frame) != all.end()) return;
    all.push_back({std::move(name), parent, X_ParentFrame});
  };
  for (const Sensor& sensor : sensors) {
    const std::string parent = frameOf(sensor.link());
    if (parent.empty()) continue;
    add(frames.toRos(sensor.frameName()), parent, sensor.poseInLink());
    // camera_info may have a frame of its own
    if (const auto* camera = sensor.settings<CameraSettings>(); camera != nullptr && !camera->opticalFrame.empty()) {
      add(frames.toRos(camera->opticalFrame), parent, sensor.poseInLink() * kOptical);
    }
  }
  return all;
}

}  // namespace

bool isRobot(const Model& model) {
  if (model.isStatic()) return false;
  if (!model.plugins().empty()) return true;
  for (const Joint& joint : model.joints()) {
    if (joint.type() != "fixed" || !joint.sensors().empty()) return true;
  }
  for (const Link& link : model.links()) {
    if (!link.sensors().empty()) return true;
  }
  return std::ranges::any_of(model.models(), [](const Model& inner) { return isRobot(inner); });
}

bool RobotList::update() {
  const auto isGone = [](const auto& each) { return !each.model.exists(); };
  bool hasChanged = std::erase_if(robots_, isGone) > 0;
  hasChanged |= std::erase_if(fixtures_, isGone) > 0;
  std::erase_if(known_, [this](ModelId id) { return !world_.model(id); });
  const std::size_t before = robots_.size() + fixtures_.size();
  for (const Model& model : world_.models()) {
    if (known_.insert(model.id()).second) examine(model);
  }
  return hasChanged || robots_.size() + fixtures_.size() != before;
}

void RobotList::examine(const Model& model) {
  const bool isNamed = std::ranges::find(settings_.robots, model.name()) != settings_.robots.end();
  if (settings_.robots.empty() ? isRobot(model) : isNamed) return addRobot(model);
  Fixture fixture{model, {}};
  if (!model.isStatic()) return;
  const std::string world = frames_.toRos(settings_.worldFrame);
  const auto frameOf = [this](const Link& link) { return frames_.toRos(link.scopedName()); };
  const std::vector<Sensor> sensors = sensorsOf(model);
  for (const Sensor& sensor : sensors) {
    SensorFrame frame{frameOf(sensor.link()), world, sensor.link().pose()};
    if (std::ranges::find(fixture.frames, frame.frame, &SensorFrame::frame) == fixture.frames.end()) {
      fixture.frames.push_back(std::move(frame));
    }
  }
  const auto isLink = [links = fixture.frames](const std::string& name) {
    return std::ranges::find(links, name, &SensorFrame::frame) != links.end();
  };
  for (SensorFrame& frame : framesOf(sensors, frames_, isLink, frameOf)) fixture.frames.push_back(std::move(frame));
  if (!fixture.frames.empty()) fixtures_.push_back(std::move(fixture));
}

void RobotList::addRobot(const Model& model) {
  Frames frames = frames_;
  const std::string name(model.name());
  const bool isOfUrdf = model.urdf() != nullptr;
  const std::vector<Sensor> sensors = sensorsOf(model);
  std::string inFile = isOfUrdf ? "" : linkPrefix(model, sensors);
  const auto treeOf = [&] {
    return isOfUrdf ? treeOfUrdf(model, frames) : treeOfModel(model, frames, inFile, settings_.worldFrame);
  };
  KinematicTree tree = treeOf();
  // two robots from the same URDF, or whose files name frames without the model, have links of the same names
  const auto isTaken = [&](const TreeLink& link) {
    const auto hasIt = [&link](const Robot& other) { return other.tree.find(link.frame).has_value(); };
    // the world's frame is everybody's
    return (isOfUrdf || link.link) && std::ranges::any_of(robots_, hasIt);
  };
  const std::string ownPrefix = name + "/";
  if (inFile != ownPrefix && std::ranges::any_of(tree.links, isTaken)) {
    if (isOfUrdf) {
      frames.prefix += ownPrefix;
    } else {
      inFile = ownPrefix;
    }
    log_.warning("robot '" + name + "' shares frame names with another robot: on /tf they are prefixed with '" +
                 frames_.prefix + ownPrefix + "'");
    tree = treeOf();
  }
  for (const std::string& remark : nameSensorPlaces(sensors, frames_, tree)) log_.warning(remark);
  Robot& robot = robots_.emplace_back(Robot{model, name, std::move(tree), {}});
  const auto frameOf = [&robot](const Link& link) {
    const std::optional<std::size_t> index = robot.tree.find(link.id());
    return index ? robot.tree.links[*index].frame : std::string();
  };
  robot.sensors = framesOf(
      sensors, frames_, [&robot](const std::string& frame) { return robot.tree.find(frame).has_value(); }, frameOf);
}

}  // namespace pongsim::ros2
