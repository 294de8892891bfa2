#pragma once

#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/robot/kinematic_tree.hh"

namespace pongsim::ros2 {

/// A text in URDF, and what of the model it can't say.
struct UrdfText {
  std::string text;
  /// Each with what stands in its place.
  std::vector<std::string> warnings;
};

/// Writes a robot that came as SDF in URDF: each link of the tree with its inertial, visuals and collisions, each joint
/// with its limits, damping and friction. The links are called as their frames are, so that what shows the robot by tf
/// needs no prefix. Meshes and textures are addresses of files on this machine ("file:///..."). Numbers read as the
/// same bits.
UrdfText writeUrdf(const World& world, const Model& model, const KinematicTree& tree);

}  // namespace pongsim::ros2
