#pragma once

#include <string>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"

namespace pongsim::ros2 {

/// The user's settings for robots: which models count, and what is published about them.
struct RobotSettings {
  /// Names of top-level models. Empty: those that look like a robot (`isRobot`).
  std::vector<std::string> robots;
  bool tellsDescription = true;
  bool tellsTransforms = true;
  /// Whether the frames of links are among them; robot_state_publisher has the same.
  bool tellsLinks = true;
  bool tellsJointStates = true;
  /// Messages per simulated second; 0: one every step.
  double transformRate = 50;
  double jointStateRate = 50;
  /// Name of the world's frame, without a prefix.
  std::string worldFrame = "world";
  /// When the world's frame is the parent of a robot's root frame: "auto": unless odometry publishes the robot's pose;
  /// "always": then it is the parent of the odometry's frame; "never".
  std::string groundTruth = "auto";

  /// If only named topics are bridged, the same applies here: what no element of the `<plugin>` asks for is not
  /// published.
  void leaveOutUnnamed(const Element& plugin) {
    tellsDescription = tellsDescription && plugin.child("robot_description") != nullptr;
    tellsTransforms = tellsTransforms && plugin.child("tf") != nullptr;
    tellsJointStates = tellsJointStates && plugin.child("joint_states") != nullptr;
  }

  void declare(Declaration& declaration) {
    declaration.parameter("robot", &robots, "", "name of a model that is a robot")
        .otherwise("all that can move and have a joint, a system or a sensor");
    declaration
        .parameter("robot_description", &tellsDescription, "", "whether robots are described on /robot_description")
        .otherwise("as bridge_all");
    declaration.parameter("tf", &tellsTransforms, "", "whether robots' frames are on /tf and /tf_static")
        .otherwise("as bridge_all");
    declaration.parameter("link_tf", &tellsLinks, "",
                          "whether robots' links are among these frames, beside odometry and sensors");
    declaration.parameter("tf_rate", &transformRate, "Hz", "messages on /tf per simulated second; 0: one per step")
        .atLeast(0);
    declaration.parameter("joint_states", &tellsJointStates, "", "whether robots' joints are on /joint_states")
        .otherwise("as bridge_all");
    declaration
        .parameter("joint_state_rate", &jointStateRate, "Hz",
                   "messages on /joint_states per simulated second; 0: one per step")
        .atLeast(0);
    declaration.parameter("world_frame", &worldFrame, "", "name of the world's frame");
    declaration
        .parameter("ground_truth", &groundTruth, "",
                   "when the world frame is a robot's parent frame: auto (without odometry), always or never")
        .oneOf({"auto", "always", "never"});
  }
};

}  // namespace pongsim::ros2
