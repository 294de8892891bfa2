#pragma once

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/scene.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Moves links and joints to recorded states regardless of constraints: for a system that does so in each step of a
/// world without physics (`SimulationOptions::physics`). Call it before `postUpdate`, on the simulation's thread. Must
/// not outlive the `Simulation`.
class PONGSIM_API StatePlayer {
 public:
  explicit StatePlayer(const Scene& scene) : access_(scene.access_) {}

  /// @return Current simulated time, and the step size.
  Time time() const;
  Time stepSize() const;

  /// Moves a link's frame, with zero velocity. A model's frame follows its canonical link.
  /// @param X_WorldLink Finite.
  /// @throws Gone if the link no longer exists; likewise below.
  void place(const Link& link, const Pose& X_WorldLink);

  /// Sets position [rad or m] and velocity [rad/s or m/s] of a joint's axis. Moves no link.
  void setAxis(const Joint& joint, int axis, double position, double velocity);

 private:
  sim::Access* access_;
};

}  // namespace pongsim
