#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/actor.hh"
#include "description/environment.hh"
#include "description/levels.hh"
#include "description/light.hh"
#include "description/model.hh"
#include "description/physics_profile.hh"
#include "description/plugin.hh"
#include "description/scene.hh"
#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A `<world>`, with resolved frames.
struct World {
  std::string name;
  SourcePosition position;
  /// World frame [m/s^2].
  Vector3 gravity{0, 0, -9.8};
  /// The profile in use: the first one marked as default, else the first.
  PhysicsProfile physics;
  /// All profiles, in the order of the file.
  std::vector<PhysicsProfile> physicsProfiles;
  Environment environment;
  Scene scene;
  /// `<gui>`, as in the file.
  std::optional<Element> gui;
  std::vector<Model> models;
  std::vector<Light> lights;
  std::vector<Actor> actors;
  /// Joints between models, defined in the world.
  std::vector<Joint> joints;
  /// Frames defined in the world. They refer to links as "model::link", or to "world".
  std::vector<Frame> frames;
  std::vector<Plugin> plugins;
  LevelPlan levels;
  bool operator==(const World&) const = default;
};

}  // namespace pongsim::description
