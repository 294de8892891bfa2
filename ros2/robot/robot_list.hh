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

/// The frame in which a sensor's messages are.
struct SensorFrame {
  std::string frame;
  std::string parent;
  Pose X_ParentSensor;
};

/// A model that is described to ROS.
struct Robot {
  Model model;
  std::string name;
  KinematicTree tree;
  /// Those that are not links of the tree.
  std::vector<SensorFrame> sensors;
};

/// A static model with sensors.
struct Fixture {
  Model model;
  /// With the links between the world and them.
  std::vector<SensorFrame> frames;
};

/// @return Whether a model looks like a robot: it is not static, and it or one that is nested in it has a joint that
/// moves, a system or a sensor.
bool isRobot(const Model& model);

/// The robots of a world, and what else has sensors, as they come and go.
class RobotList {
 public:
  RobotList(const World& world, const Frames& frames, const RobotSettings& settings)
      : world_(world), frames_(frames), settings_(settings) {}

  /// Looks which models have come and gone; those that stayed are not looked into.
  /// @return Whether a robot or a fixture has.
  bool update();

  const std::list<Robot>& robots() const { return robots_; }
  std::list<Robot>& robots() { return robots_; }
  const std::list<Fixture>& fixtures() const { return fixtures_; }

 private:
  void examine(const Model& model);
  void addRobot(const Model& model);

  World world_;
  Frames frames_;
  RobotSettings settings_;
  Logger log_{"ros2"};
  /// All models of the top level that were looked into.
  std::set<ModelId> known_;
  std::list<Robot> robots_;
  std::list<Fixture> fixtures_;
};

}  // namespace pongsim::ros2
