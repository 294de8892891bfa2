#pragma once

#include <memory>
#include <optional>
#include <string>

#include "pongsim/messages/message_encoder.hh"

namespace CLI {
class App;
}

namespace pongsim::log {

/// Whether a log should contain ROS messages, and which.
struct Ros2Choice {
  bool isWanted = false;
  /// In the format of ros_gz_bridge.
  std::optional<std::string> configFile;
};

/// Adds `--ros2` and `--ros2-config` to an action.
/// @param ros2 Gets the user's choice. Must outlive the action.
void addRos2Options(CLI::App& action, Ros2Choice& ros2);

/// Prints the diagnostics of the configuration.
/// @return An encoder that makes ROS messages.
/// @throws Failure if it is not installed, or the configuration has errors.
std::unique_ptr<MessageEncoder> ros2Encoder(const Ros2Choice& ros2);

}  // namespace pongsim::log
