#pragma once

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/scene.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Puts links and joints of a world where a recording has them, whatever holds them to each other: for a system that
/// does so in each step of a world whose physics rests (`SimulationOptions::physics`). Call it before `postUpdate`, on
/// the simulation's thread. It must not outlive the `Simulation`.
class PONGSIM_API StatePlayer {
 public:
  explicit StatePlayer(const Scene& scene) : access_(scene.access_) {}

  /// @return Simulated time now, and the length of a step.
  Time time() const;
  Time stepSize() const;

  /// Puts the link's frame there, with no velocity. The frame of a model is where its canonical link has it.
  /// @param X_WorldLink Finite.
  /// @throws Gone where the link is not there any more; likewise below.
  void place(const Link& link, const Pose& X_WorldLink);

  /// Sets what the joint says of an axis: position [rad or m] and velocity [rad/s or m/s]. No link moves by it.
  void setAxis(const Joint& joint, int axis, double position, double velocity);

 private:
  sim::Access* access_;
};

}  // namespace pongsim
