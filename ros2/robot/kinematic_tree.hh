#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

/// How a link moves against its parent in the tree.
enum class Motion {
  kFixed,
  /// About the axis [rad].
  kTurning,
  /// Along the axis [m].
  kSliding,
  /// In a way that URDF has no joint for: it calls that "floating".
  kFree,
};

/// A link of a robot as URDF and tf have it: its frame is also that of the joint above it.
struct TreeLink {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Name of the frame in ROS, in full.
  std::string frame = {};
  /// The simulation's. None for what it has no link for: the world, what stands between two joints, a link of a URDF
  /// that became part of another one.
  std::optional<Link> link = std::nullopt;
  /// Which of the tree's links it hangs on, one that stands before it; kNone for the root.
  std::size_t parent = kNone;
  /// Name of the joint in URDF.
  std::string joint = {};
  Motion motion = Motion::kFixed;
  /// Of the link frame in that of the parent while the joint is at zero; of a free one as it was at first.
  Pose X_ParentLink = {};
  /// Unit vector in the link frame.
  Vector3 axis = Vector3::UnitZ();
  /// The simulation's joint whose position counts; none where it has none, which then is as one at zero.
  std::optional<Joint> source = std::nullopt;
  int sourceAxis = 0;
};

/// The links of a robot from the root down, each behind the one that it hangs on.
struct KinematicTree {
  std::vector<TreeLink> links;
  /// What of the model URDF can't say, each with what becomes of it.
  std::vector<std::string> warnings;

  /// @return Which link has that frame, or none.
  std::optional<std::size_t> find(std::string_view frame) const;
  /// @return Which link is that one of the simulation, or none.
  std::optional<std::size_t> find(LinkId link) const;

  /// @return Pose of the root in the world, as it is now.
  Pose rootPose(const Model& model) const;
  /// @return Pose of the link in its parent's frame, as it is now: by the position of the joint; of a free one by where
  /// the simulation has the two.
  Pose poseInParent(std::size_t link, const Model& model) const;
  /// @return Pose of the link in the frame of the root, as it is now.
  Pose poseInRoot(std::size_t link, const Model& model) const;
};

/// Makes a tree of a model and all that is nested in it.
///
/// The root is the world, where a joint hangs on it, else a link that no joint moves, the canonical one where there is
/// a choice. What the joints connect hangs on it by them, in whichever direction. A joint with two axes becomes two,
/// with a link in between; a link whose frame is not on the axis of its joint gets one too. Joints that close a loop
/// are left out; what hangs on nothing, and what moves in a way that URDF does not know (ball, screw), is free. All
/// that is in `warnings`.
/// @param frames Makes the frames' names of those of the links: "vehicle_blue/chassis".
/// @param worldFrame What the world is called, without a prefix.
KinematicTree treeOfModel(const Model& model, const Frames& frames, std::string_view worldFrame);

/// Makes a tree of a model that was made from URDF: that of its URDF, with all links that the simulation has made part
/// of others. The frames have the links' names, with the prefix.
KinematicTree treeOfUrdf(const Model& model, const Frames& frames);

}  // namespace pongsim::ros2
