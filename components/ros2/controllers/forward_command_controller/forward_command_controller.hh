#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros2/controllers/controller.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2 {

/// Forwards the numbers of `~/commands` to command interfaces. The classes of position_controllers and the like have
/// the interface in their name; another one commands several interfaces of one joint.
class ForwardCommandController final : public Controller {
 public:
  /// @param interface "position", or "" for the parameter `interface_name`; "*" for several of one joint.
  explicit ForwardCommandController(std::string interface) : interface_(std::move(interface)) {}

  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override { return {.commands = names_}; }
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override { values_.reset(); }
  void transfer(StateArchive& archive) override;

 private:
  void receive(const std_msgs::Float64MultiArray& message);

  std::string interface_;
  std::string name_;
  std::vector<std::string> names_;
  const Logger* log_ = nullptr;
  bool hasWarned_ = false;
  std::unique_ptr<RosSubscription> commands_;
  std::vector<const HardwareInterfaces::Command*> handles_;
  /// The last command; nothing before the first.
  std::optional<std::vector<double>> values_;
};

}  // namespace pongsim::ros2
