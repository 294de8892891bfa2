#pragma once

#include <string>

namespace pongsim::assets {

/// What the limbs of a figure do.
struct Gait {
  /// Name of the actor's animation; of another name: the motion in the skin's own file.
  std::string animation;
  /// Since the animation's start [s].
  double time = 0;
  /// Since then, along the path [m].
  double distance = 0;
  /// Whether the animation begins again after its end.
  bool loops = true;
  /// Whether the skeleton's root stays where the actor is, and only turns.
  bool isOnPath = true;

  bool operator==(const Gait&) const = default;
};

}  // namespace pongsim::assets
