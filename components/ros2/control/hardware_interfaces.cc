#include "ros2/control/hardware_interfaces.hh"

#include <algorithm>
#include <utility>

#include "ros2/robot/joint_effort.hh"

namespace pongsim::ros2 {

void HardwareInterfaces::addJoint(JointDriver& driver, std::size_t joint, const std::vector<std::string>& commands,
                                  const std::vector<std::string>& states) {
  using Interface = JointDriver::Interface;
  const std::string prefix = driver.joints()[joint].name;
  for (const std::string& name : commands) {
    const Interface interface = name == "position"   ? Interface::kPosition
                                : name == "velocity" ? Interface::kVelocity
                                : name == "effort"   ? Interface::kEffort
                                                     : Interface::kNone;
    // a joint that follows another one takes no commands
    if (interface == Interface::kNone || driver.joints()[joint].mimic) continue;
    commands_.push_back({prefix + "/" + name, &driver, joint, interface});
  }
  for (const std::string& name : states) {
    const auto read = [&driver, joint, name]() -> double {
      const Joint& handle = driver.joint(joint);
      return name == "position" ? handle.position() : name == "velocity" ? handle.velocity() : jointEffort(handle);
    };
    if (name == "position" || name == "velocity" || name == "effort") addState(prefix, name, read);
  }
}

void HardwareInterfaces::addState(std::string prefix, std::string interface, std::function<double()> read) {
  states_.push_back({std::move(prefix), std::move(interface), std::move(read)});
}

HardwareInterfaces::Command* HardwareInterfaces::command(std::string_view name) {
  const auto found = std::ranges::find(commands_, name, &Command::name);
  return found == commands_.end() ? nullptr : &*found;
}

const HardwareInterfaces::State* HardwareInterfaces::state(std::string_view name) const {
  const auto found = std::ranges::find_if(states_, [name](const State& state) { return state.name() == name; });
  return found == states_.end() ? nullptr : &*found;
}

}  // namespace pongsim::ros2
