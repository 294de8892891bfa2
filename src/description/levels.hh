#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A part of a world that is there while a performer is near.
struct Level {
  /// A `<ref>`: the name of a model, light or actor of the world.
  struct Member {
    std::string name;
    SourcePosition position;
    bool operator==(const Member&) const = default;
  };
  std::string name;
  SourcePosition position;
  /// Middle and full lengths of its box, which lies along the axes of the world [m].
  Vector3 center = Vector3::Zero();
  Vector3 size = Vector3::Ones();
  /// By how much a performer must be out of the box on each side for the level to go [m].
  double buffer = 0;
  std::vector<Member> members;
  bool operator==(const Level&) const = default;
};

/// A model or actor that makes levels come and go.
struct Performer {
  std::string name;
  SourcePosition position;
  /// The model or actor.
  std::string ref;
  /// Full lengths of its box, which lies along the axes of the world around its origin [m].
  Vector3 size = Vector3::Ones();
  bool operator==(const Performer&) const = default;
};

/// What stands in the world's plugin `gz::sim`.
struct LevelPlan {
  /// There is such a plugin.
  bool isGiven = false;
  std::vector<Level> levels;
  std::vector<Performer> performers;
  bool operator==(const LevelPlan&) const = default;
};

/// @param className `name` of a `<plugin>`.
/// @return Whether it is no system but holds levels and performers.
inline bool isLevelPlan(std::string_view className) {
  return className == "gz::sim" || className == "ignition::gazebo";
}

}  // namespace pongsim::description
