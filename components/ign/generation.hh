#pragma once

#include "pongsim/program/gazebo_variable.hh"

namespace pongsim::ign {

/// Which clients a process is for. The packets are the same; names of message types and of environment variables
/// differ.
enum class Generation {
  /// Those of Fortress, with ign-transport 11: ignition.msgs.Twist, IGN_PARTITION.
  kIgn,
  /// Those of Garden and later releases, with gz-transport 12 to 15: gz.msgs.Twist, GZ_PARTITION.
  kGz
};

/// @return The variable's name for these clients, which do not read the other one.
constexpr const char* nameFor(const GazeboVariable& variable, Generation generation) {
  return generation == Generation::kIgn ? variable.fortress : variable.later;
}

}  // namespace pongsim::ign
