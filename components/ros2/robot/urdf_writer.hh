#pragma once

#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/robot/kinematic_tree.hh"

namespace pongsim::ros2 {

/// A URDF text, and what it can't express of the model.
struct UrdfText {
  std::string text;
  /// Each with what replaces it.
  std::vector<std::string> warnings;
};

/// Writes a robot loaded from SDF as URDF: each link of the tree with its inertial, visuals and collisions, each joint
/// with its limits, damping and friction. Links are named like their frames, so that programs that display the robot
/// with tf need no prefix. Meshes and textures are addresses of files on this machine ("file:///..."). Numbers read as
/// the same bits.
UrdfText writeUrdf(const World& world, const Model& model, const KinematicTree& tree);

}  // namespace pongsim::ros2
