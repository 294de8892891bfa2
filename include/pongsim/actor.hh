#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Handle to an actor of a running world. Copies refer to the same actor. Must not outlive its `Simulation`.
class PONGSIM_API Actor {
 public:
  /// @return The actor with that name, if it exists.
  static std::optional<Actor> find(const World& world, std::string_view name);

  ActorId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  std::string_view name() const;
  /// @return The names of its `<animation>`s, in the order of the file.
  std::vector<std::string> animations() const;
  /// @return Its pose in the world as given in the file.
  Pose startPose() const;
  /// @return Its current pose in the world: from its script, or where it was moved.
  Pose pose() const;
  /// Moves it to a pose, overriding its script, until the world is reset. A pose that is not finite is refused with a
  /// warning. Not part of a saved state: the system that moves it must remember the pose.
  /// @param animation Name of the limbs' animation, and the time in it. Published for viewers; pongsim's own images do
  /// not show moving limbs.
  void move(const Pose& X_WorldActor, std::string_view animation = {}, Time animationTime = Time(0));

 private:
  friend class sim::SystemSet;
  Actor(sim::Access& access, ActorId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  ActorId id_;
};

}  // namespace pongsim
