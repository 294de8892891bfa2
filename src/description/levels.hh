#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A part of a world that is loaded only while a performer is near.
struct Level {
  /// A `<ref>`: the name of a model, light or actor of the world.
  struct Member {
    std::string name;
    SourcePosition position;
    bool operator==(const Member&) const = default;
  };
  std::string name;
  SourcePosition position;
  /// Centre and full side lengths of its box, aligned with the world's axes [m].
  Vector3 center = Vector3::Zero();
  Vector3 size = Vector3::Ones();
  /// How far outside the box a performer must be, on any side, before the level is unloaded [m].
  double buffer = 0;
  std::vector<Member> members;
  bool operator==(const Level&) const = default;
};

/// A model or actor whose position decides which levels are loaded.
struct Performer {
  std::string name;
  SourcePosition position;
  /// Name of the model or actor.
  std::string ref;
  /// Full side lengths of its box, centred on its origin and aligned with the world's axes [m].
  Vector3 size = Vector3::Ones();
  bool operator==(const Performer&) const = default;
};

/// Content of the world's `gz::sim` plugin.
struct LevelPlan {
  /// Whether there is such a plugin.
  bool isGiven = false;
  std::vector<Level> levels;
  std::vector<Performer> performers;
  bool operator==(const LevelPlan&) const = default;
};

/// @param className `name` of a `<plugin>`.
/// @return Whether the plugin is not a system but contains levels and performers.
inline bool isLevelPlan(std::string_view className) {
  return className == "gz::sim" || className == "ignition::gazebo";
}

}  // namespace pongsim::description
