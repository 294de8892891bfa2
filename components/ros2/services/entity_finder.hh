#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

/// A frame and its motion relative to the world.
struct MovingFrame {
  /// In the world frame.
  Pose pose;
  /// Of its origin, world frame [m/s].
  Vector3 linear = Vector3::Zero();
  /// World frame [rad/s].
  Vector3 angular = Vector3::Zero();
};

/// @return The model's frame.
MovingFrame movingFrame(const Model& model);

/// Finds what services refer to by name: entities, which are models, and frames.
class EntityFinder {
 public:
  EntityFinder(const World& world, Frames frames) : world_(world), frames_(std::move(frames)) {}

  /// @return The top-level models that have a link, directly or in a nested model.
  std::vector<Model> entities() const;
  /// @return The other top-level models: they are named poses.
  std::vector<Model> poses() const;

  /// @param name Name of a model; nested ones as "outer::inner".
  Outcome<Model> find(const std::string& name) const;

  /// @param id A frame in ROS: empty or "world", a model, a link as "model/link", or a `<frame>` of the world. With or
  /// without the prefix of all frames.
  Outcome<MovingFrame> frame(const std::string& id) const;

  const World& world() const { return world_; }

 private:
  std::optional<MovingFrame> frameNamed(const std::string& name) const;

  World world_;
  Frames frames_;
};

}  // namespace pongsim::ros2
