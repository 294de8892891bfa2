#include "ros2/robot/frame_names.hh"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/sensing/sensor_settings.hh"

namespace pongsim::ros2 {

namespace {

/// Farther from its link's frame than this, a sensor is elsewhere [m, rad].
constexpr double kSamePlace = 1e-3;

/// "robot::arm::tool" of a robot: "arm/tool".
std::string pathInModel(const Model& model, const Link& link) {
  return Frames().toRos(link.scopedName()).substr(model.name().size() + 1);
}

void addLinks(const Model& model, std::vector<Link>& links) {
  for (const Link& link : model.links()) links.push_back(link);
  for (const Model& inner : model.models()) addLinks(inner, links);
}

/// The frames that the file names by itself, those of odometry first.
std::vector<std::string> namedFrames(const Model& model, const std::vector<Sensor>& sensors) {
  std::vector<std::string> names;
  for (const Element* plugin : model.plugins()) {
    for (const char* name : {"child_frame_id", "robot_base_frame"}) {
      if (const Element* frame = plugin->child(name)) names.push_back(Frames().toRos(frame->text));
    }
  }
  for (const Sensor& sensor : sensors) {
    if (sensor.frameName() != sensor.scopedName()) names.push_back(Frames().toRos(sensor.frameName()));
  }
  return names;
}

bool isElsewhere(const Pose& X_LinkSensor) {
  // the vector part is the sine of half the angle
  return X_LinkSensor.position.norm() > kSamePlace || 2 * X_LinkSensor.rotation.vec().norm() > kSamePlace;
}

bool isHeldOnly(const KinematicTree& tree, std::size_t index) {
  const TreeLink& link = tree.links[index];
  return link.parent != TreeLink::kNone && link.motion == Motion::kFixed &&
         std::ranges::none_of(tree.links, [index](const TreeLink& each) { return each.parent == index; });
}

bool seesPlaces(const Sensor& sensor) {
  return sensor.settings<LidarSettings>() != nullptr || sensor.settings<CameraSettings>() != nullptr;
}

}  // namespace

std::string linkPrefix(const Model& model, const std::vector<Sensor>& sensors) {
  std::vector<Link> links;
  addLinks(model, links);
  std::vector<std::string> paths;
  for (const Link& link : links) paths.push_back(pathInModel(model, link));
  for (const std::string& frame : namedFrames(model, sensors)) {
    for (const std::string& path : paths) {
      if (!frame.ends_with(path)) continue;
      const std::string before = frame.substr(0, frame.size() - path.size());
      if (before.empty() || before.ends_with('/')) return before;
    }
  }
  return std::string(model.name()) + "/";
}

std::vector<std::string> nameSensorPlaces(const std::vector<Sensor>& sensors, const Frames& frames,
                                          KinematicTree& tree) {
  std::vector<std::string> remarks;
  for (const Sensor& sensor : sensors) {
    const std::string frame = frames.toRos(sensor.frameName());
    const std::optional<std::size_t> index = tree.find(sensor.link().id());
    if (!index || tree.links[*index].frame != frame || !isElsewhere(sensor.poseInLink())) continue;
    // frames of a URDF are its links, as its text says
    if (isHeldOnly(tree, *index) && sensor.link().model().urdf() == nullptr) {
      std::string name = frames.toRos(sensor.link().scopedName());
      while (tree.find(name)) name += '_';
      tree.links[*index].frame = name;
    } else if (seesPlaces(sensor)) {
      remarks.push_back("the messages of sensor '" + sensor.scopedName() + "' are in frame '" + frame +
                        "', as its file says, but its <pose> in that link is another: nodes see its points displaced; "
                        "move the pose from the sensor to the link");
    }
  }
  return remarks;
}

}  // namespace pongsim::ros2
