#pragma once

#include <memory>
#include <optional>
#include <string>

#include "pongsim/messages/message_encoder.hh"

namespace CLI {
class App;
}

namespace pongsim::log {

/// Whether a log is to have messages of ROS, and which.
struct Ros2Wish {
  bool isWanted = false;
  /// As ros_gz_bridge takes it.
  std::optional<std::string> configFile;
};

/// Adds `--ros2` and `--ros2-config` to an action.
/// @param wish Gets what the user says. Must outlive the action.
void addRos2Options(CLI::App& action, Ros2Wish& wish);

/// Says what is wrong with the configuration.
/// @return What makes messages of ROS.
/// @throws Failure where it is not installed, or the configuration has errors.
std::unique_ptr<MessageEncoder> ros2Encoder(const Ros2Wish& wish);

}  // namespace pongsim::log
