#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

/// How a link moves relative to its parent in the tree.
enum class Motion {
  kFixed,
  /// About the axis [rad].
  kTurning,
  /// Along the axis [m].
  kSliding,
  /// Motion for which URDF has no joint: "floating" in URDF.
  kFree,
};

/// A link of a robot in the sense of URDF and tf: its frame is also that of its parent joint.
struct TreeLink {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Full name of the frame in ROS.
  std::string frame = {};
  /// The simulation's link. Empty for the world, for a link between the two axes of a joint, and for a URDF link that
  /// became part of another.
  std::optional<Link> link = std::nullopt;
  /// Index of its parent in the tree, which comes earlier; kNone for the root.
  std::size_t parent = kNone;
  /// Name of the joint in URDF.
  std::string joint = {};
  Motion motion = Motion::kFixed;
  /// Pose of the link frame in the parent's while the joint is at zero; for a free link, the initial pose.
  Pose X_ParentLink = {};
  /// Unit vector in the link frame.
  Vector3 axis = Vector3::UnitZ();
  /// The simulation's joint that gives the position; empty if there is none, which means zero.
  std::optional<Joint> source = std::nullopt;
  int sourceAxis = 0;
};

/// The links of a robot from the root down, each after its parent.
struct KinematicTree {
  std::vector<TreeLink> links;
  /// Properties of the model that URDF can't express, each with what becomes of it.
  std::vector<std::string> warnings;

  /// @return Index of the link with this frame, if any.
  std::optional<std::size_t> find(std::string_view frame) const;
  /// @return Index of the tree's link for this link of the simulation, if any.
  std::optional<std::size_t> find(LinkId link) const;

  /// @return Current pose of the root in the world.
  Pose rootPose(const Model& model) const;
  /// @return Current pose of the link in its parent's frame: from the joint's position; for a free link, from the poses
  /// of the two in the simulation.
  Pose poseInParent(std::size_t link, const Model& model) const;
  /// @return Current pose of the link in the root's frame.
  Pose poseInRoot(std::size_t link, const Model& model) const;
};

/// Builds a tree from a model and everything nested in it.
///
/// The root is the world if a joint connects to it, else a link that no joint moves, preferably the canonical one.
/// Links connected by joints follow, whichever end of the joint is nearer to the root. A joint with two axes becomes
/// two, with a link in between; a link whose frame is not on its joint's axis also gets an extra link. Joints that
/// close a loop are left out. Links that are not connected, or move in a way unknown to URDF (ball, screw), are free.
/// All of this is reported in `warnings`.
/// @param frames Has the prefix of all frames.
/// @param linkPrefix Precedes the names of links in their frames, after that prefix: "vehicle_blue/" (`linkPrefix`).
/// @param worldFrame Name of the world's frame, without a prefix.
KinematicTree treeOfModel(const Model& model, const Frames& frames, std::string_view linkPrefix,
                          std::string_view worldFrame);

/// Builds the tree of a model converted from URDF: the tree of its URDF, including all links that the simulation has
/// merged into others. Frames have the links' names, with the prefix.
KinematicTree treeOfUrdf(const Model& model, const Frames& frames);

}  // namespace pongsim::ros2
