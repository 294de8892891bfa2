#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::ros2 {

/// A `<joint>` of a `<ros2_control>`: how it can be commanded, and where it begins.
struct ControlledJoint {
  struct Mimic {
    std::string joint;
    double multiplier = 1;
    double offset = 0;
  };

  std::string name;
  SourcePosition position;
  bool takesPosition = false;
  bool takesVelocity = false;
  bool takesEffort = false;
  /// Which joint it follows; it then takes no commands.
  std::optional<Mimic> mimic;
  /// [rad or m], [rad/s or m/s]
  std::optional<double> initialPosition;
  std::optional<double> initialVelocity;

  bool isCommanded() const { return takesPosition || takesVelocity || takesEffort; }
};

/// What the `<ros2_control>` blocks of a robot list. Blocks that speak on the same topics are one.
struct ControlBlock {
  /// As `<param>`s of `<hardware>` say; empty where they say nothing.
  std::string commandsTopic;
  std::string statesTopic;
  std::vector<ControlledJoint> joints;
};

/// @param holder A `<robot>`, whose `<joint>`s may have a `<mimic>`, or another element that has the blocks below it.
/// @param diagnostics Warnings about what has no effect, errors about numbers that are none; what is wrong is left out.
std::vector<ControlBlock> controlBlocks(const Element& holder, Diagnostics& diagnostics);

}  // namespace pongsim::ros2
