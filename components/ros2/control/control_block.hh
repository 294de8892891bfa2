#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::ros2 {

/// A `<joint>` of a `<ros2_control>`: its command interfaces and initial values.
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
  /// The joint that it mimics; it then accepts no commands.
  std::optional<Mimic> mimic;
  /// [rad or m], [rad/s or m/s]
  std::optional<double> initialPosition;
  std::optional<double> initialVelocity;

  bool isCommanded() const { return takesPosition || takesVelocity || takesEffort; }
};

/// The content of a robot's `<ros2_control>` blocks. Blocks that use the same topics are merged.
struct ControlBlock {
  /// From the `<param>`s of `<hardware>`; empty if missing.
  std::string commandsTopic;
  std::string statesTopic;
  std::vector<ControlledJoint> joints;
};

/// @param holder A `<robot>`, whose `<joint>`s can have a `<mimic>`, or another parent of the blocks.
/// @param diagnostics Warnings about elements without effect, errors about invalid numbers; invalid parts are left out.
std::vector<ControlBlock> controlBlocks(const Element& holder, Diagnostics& diagnostics);

}  // namespace pongsim::ros2
