#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ros2/controllers/controller.hh"
#include "ros2/types/geometry_msgs.hh"

namespace pongsim::ros2 {

/// What a drive is commanded.
struct TwistCommand {
  Time stamp{0};
  /// Forward and to the left [m/s].
  double linear = 0;
  double lateral = 0;
  /// [rad/s]
  double angular = 0;

  void transfer(StateArchive& archive) {
    archive(stamp);
    archive(linear);
    archive(lateral);
    archive(angular);
  }
};

/// The velocities that a drive is commanded, by a geometry_msgs/TwistStamped or Twist.
class TwistInput {
 public:
  /// Subscribes.
  /// @param timeout Commands that are older when they arrive are ignored; zero: none.
  /// @param isStamped Whether the type is TwistStamped.
  void configure(const ControllerSetup& setup, const std::string& topic, Time timeout, bool isStamped = true);
  /// Commands are taken from now on, or ignored.
  void enable(bool isEnabled);
  /// @return The last command; nothing before the first.
  const std::optional<TwistCommand>& command() const { return command_; }
  void clear() { command_.reset(); }
  void transfer(StateArchive& archive) { archive(command_); }

 private:
  void receive(const geometry_msgs::Twist& twist, Time stamp);
  void warnOnce(const std::string& what);

  const Logger* log_ = nullptr;
  std::string name_;
  std::function<Time()> now_;
  Time timeout_{0};
  bool isEnabled_ = false;
  std::string warned_;
  std::optional<TwistCommand> command_;
  std::unique_ptr<RosSubscription> subscription_;
};

}  // namespace pongsim::ros2
