#pragma once

#include <cstddef>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/sensing/sensor.hh"
#include "ros2/pairs/frames.hh"
#include "ros2/robot/kinematic_tree.hh"
#include "ros2/robot/robot_settings.hh"

namespace pongsim::ros2 {

/// The frame of a sensor's messages.
struct SensorFrame {
  std::string frame;
  std::string parent;
  Pose X_ParentSensor;
};

/// A model that is published to ROS.
struct Robot {
  Model model;
  std::string name;
  KinematicTree tree;
  /// Sensors with a frame that is not a link of the tree.
  std::vector<SensorFrame> sensors;
};

/// A static model with sensors.
struct Fixture {
  Model model;
  /// Including the links between the world and the sensors.
  std::vector<SensorFrame> frames;
};

/// @return Whether a model looks like a robot: it is not static, and it or a nested model has a movable joint, a system
/// or a sensor.
bool isRobot(const Model& model);

/// The robots of a world, and other models with sensors, kept up to date.
class RobotList {
 public:
  RobotList(const World& world, const Frames& frames, const RobotSettings& settings)
      : world_(world), frames_(frames), settings_(settings) {}

  /// Checks which models have been added or removed; existing ones are not examined again.
  /// @return Whether a robot or a fixture was added or removed.
  bool update();

  const std::list<Robot>& robots() const { return robots_; }
  const std::list<Fixture>& fixtures() const { return fixtures_; }

 private:
  void examine(const Model& model);
  void addRobot(const Model& model);

  World world_;
  Frames frames_;
  RobotSettings settings_;
  Logger log_{"ros2"};
  /// All top-level models that have been examined.
  std::set<ModelId> known_;
  std::list<Robot> robots_;
  std::list<Fixture> fixtures_;
};

}  // namespace pongsim::ros2
