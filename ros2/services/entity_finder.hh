#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

/// A frame and how it moves, seen from the world.
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

/// Finds by name what services speak of: entities, which are models, and frames.
class EntityFinder {
 public:
  EntityFinder(const World& world, Frames frames) : world_(world), frames_(std::move(frames)) {}

  /// @return The models at the top level that have a link, in them or in those nested in them.
  std::vector<Model> entities() const;
  /// @return The others: they are poses with a name.
  std::vector<Model> poses() const;

  /// @param name A model's; one that is nested is "outer::inner".
  Outcome<Model> find(const std::string& name) const;

  /// @param id Of a frame as ROS has it: empty or "world", a model, a link as "model/link", or a `<frame>` of the
  /// world. With the prefix of all frames or without.
  Outcome<MovingFrame> frame(const std::string& id) const;

  const World& world() const { return world_; }

 private:
  std::optional<MovingFrame> frameNamed(const std::string& name) const;

  World world_;
  Frames frames_;
};

}  // namespace pongsim::ros2
