#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "description/link.hh"
#include "description/plugin.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A file of an actor: its `<skin>` or an `<animation>`.
struct ActorFile {
  /// As written in the file; empty: none.
  std::string uri;
  /// The resolved path; empty if the file does not exist.
  std::filesystem::path file;
  double scale = 1;
  bool operator==(const ActorFile&) const = default;
};

/// `<animation>`: motion of an actor's limbs.
struct Animation {
  std::string name;
  ActorFile source;
  /// The animation's speed follows the actor's speed along x.
  bool followsPath = false;
  bool operator==(const Animation&) const = default;
};

/// `<waypoint>`
struct Waypoint {
  /// Time since the start of the script [s].
  double time = 0;
  /// In the frame of the actor.
  Pose X_ActorWaypoint;
  bool operator==(const Waypoint&) const = default;
};

/// `<trajectory>`: a path that an actor follows.
struct Trajectory {
  long long id = 0;
  /// Name of the animation to play along it.
  std::string type;
  /// Tension of the spline through the points: 0: Catmull-Rom, 1: straight lines.
  double tension = 0;
  /// In the order of the file.
  std::vector<Waypoint> waypoints;
  bool operator==(const Trajectory&) const = default;
};

/// An `<actor>`: an animated figure that moves by a script, regardless of what it hits.
struct Actor {
  std::string name;
  SourcePosition position;
  Pose X_WorldActor;
  ActorFile skin;
  /// Visuals of its links, in the actor's frame (`X_LinkVisual`).
  std::vector<Visual> visuals;
  std::vector<Animation> animations;
  /// `<script>`: whether it repeats after the end.
  bool loops = true;
  /// Simulated seconds before the first run.
  double startDelay = 0;
  bool startsByItself = true;
  std::vector<Trajectory> trajectories;
  std::vector<Plugin> plugins;
  /// As of a model.
  std::optional<std::uint8_t> label = {};
  bool operator==(const Actor&) const = default;
};

/// @return Everything visible of an actor, in its frame: its skin, if any, and the visuals of its links.
std::vector<Visual> visualsOf(const Actor& actor);

}  // namespace pongsim::description
