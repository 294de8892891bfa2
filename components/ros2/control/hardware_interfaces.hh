#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/control/joint_driver.hh"

namespace pongsim::ros2 {

/// The command and state interfaces of a robot's hardware by name: "left_wheel_joint/velocity".
class HardwareInterfaces {
 public:
  struct Command {
    std::string name;
    JointDriver* driver = nullptr;
    std::size_t joint = 0;
    JointDriver::Interface interface = JointDriver::Interface::kNone;
    /// The controller that commands it; empty: none.
    std::string owner = {};

    void set(double value) const { driver->set(joint, interface, value); }
    double get() const { return driver->get(joint, interface); }
  };
  struct State {
    /// "left_wheel_joint", "velocity"
    std::string prefix;
    std::string interface;
    std::function<double()> read;

    std::string name() const { return prefix + "/" + interface; }
  };

  /// Adds the interfaces of a joint; unknown ones are left out.
  /// @param driver Must outlive it.
  void addJoint(JointDriver& driver, std::size_t joint, const std::vector<std::string>& commands,
                const std::vector<std::string>& states);
  void addState(std::string prefix, std::string interface, std::function<double()> read);

  /// In the order of their addition; their addresses stay.
  std::deque<Command>& commands() { return commands_; }
  const std::deque<Command>& commands() const { return commands_; }
  const std::deque<State>& states() const { return states_; }

  /// @return Null if there is none; the same below.
  Command* command(std::string_view name);
  const State* state(std::string_view name) const;

 private:
  std::deque<Command> commands_;
  std::deque<State> states_;
};

}  // namespace pongsim::ros2
