#pragma once

#include <string>
#include <vector>

#include "description/environment.hh"
#include "description/model.hh"
#include "description/plugin.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A `<physics>` profile.
struct PhysicsProfile {
  std::string name;
  Time maxStepSize = std::chrono::milliseconds(1);
  /// Simulated seconds a second; 0 means as many as possible.
  double realTimeFactor = 1;
  bool operator==(const PhysicsProfile&) const = default;
};

struct Light {
  std::string name;
  std::string type;
  Pose X_WorldLight;
  SourcePosition position;
  bool operator==(const Light&) const = default;
};

/// What a `<world>` says, frames resolved.
struct World {
  std::string name;
  SourcePosition position;
  /// World frame [m/s^2].
  Vector3 gravity{0, 0, -9.8};
  PhysicsProfile physics;
  Environment environment;
  std::vector<Model> models;
  std::vector<Light> lights;
  /// Joints that connect models at the world's level.
  std::vector<Joint> joints;
  /// Frames at the world's level; the world stands for their model: links are named "model::link", or "world".
  std::vector<Frame> frames;
  std::vector<Plugin> plugins;
  bool operator==(const World&) const = default;
};

}  // namespace pongsim::description
