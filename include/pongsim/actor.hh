#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A way to one actor of a running world. A copy is the same actor; it must not outlive its `Simulation`.
class PONGSIM_API Actor {
 public:
  /// @return The actor of that name, if it is there.
  static std::optional<Actor> find(const World& world, std::string_view name);

  ActorId id() const { return id_; }
  /// @return Whether it is there. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  std::string_view name() const;
  /// @return Names of its `<animation>`s, in the order of the file.
  std::vector<std::string> animations() const;
  /// @return Pose in the world that the file gives it.
  Pose startPose() const;
  /// @return Pose in the world now: that of its script, or where it was moved.
  Pose pose() const;
  /// Puts it there, whatever its script says, from now on and until the world is reset. A pose that is not finite is
  /// refused with a warning. Not part of a saved state: systems remember where they have put it.
  /// @param animation Name of the movement of its limbs, and how far on that is. Those who show the world are told it;
  /// the limbs do not move in pictures of ours.
  void move(const Pose& X_WorldActor, std::string_view animation = {}, Time animationTime = Time(0));

 private:
  friend class sim::SystemSet;
  Actor(sim::Access& access, ActorId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  ActorId id_;
};

}  // namespace pongsim
