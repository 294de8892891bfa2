#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "description/link.hh"
#include "description/plugin.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A file that an actor is made of, `<skin>`, or moves by, `<animation>`.
struct ActorFile {
  /// As it stands in the description's file; empty: none is named.
  std::string uri;
  /// What it names; empty where that is not there.
  std::filesystem::path file;
  double scale = 1;
  bool operator==(const ActorFile&) const = default;
};

/// `<animation>`: a movement of an actor's limbs.
struct Animation {
  std::string name;
  ActorFile source;
  /// The movement goes as fast as the actor goes along x.
  bool followsPath = false;
  bool operator==(const Animation&) const = default;
};

/// `<waypoint>`
struct Waypoint {
  /// Since the script began [s].
  double time = 0;
  /// In the frame of the trajectory's actor.
  Pose X_ActorWaypoint;
  bool operator==(const Waypoint&) const = default;
};

/// `<trajectory>`: a way that an actor goes.
struct Trajectory {
  long long id = 0;
  /// Name of the animation that goes with it.
  std::string type;
  /// Of the spline through the points: 0: Catmull-Rom, 1: straight lines.
  double tension = 0;
  /// In the order of the file.
  std::vector<Waypoint> waypoints;
  bool operator==(const Trajectory&) const = default;
};

/// What an `<actor>` says: a figure that moves as it is told, whatever it meets.
struct Actor {
  std::string name;
  SourcePosition position;
  Pose X_WorldActor;
  ActorFile skin;
  /// Of its links, in the actor's frame (`X_LinkVisual`).
  std::vector<Visual> visuals;
  std::vector<Animation> animations;
  /// `<script>`: it begins anew when it has ended.
  bool loops = true;
  /// Simulated seconds before the first beginning.
  double startDelay = 0;
  bool startsByItself = true;
  std::vector<Trajectory> trajectories;
  std::vector<Plugin> plugins;
  bool operator==(const Actor&) const = default;
};

/// @return All that is to be seen of an actor, in its frame: its skin, where it has one, and the visuals of its links.
std::vector<Visual> visualsOf(const Actor& actor);

}  // namespace pongsim::description
