#include "ros2/controllers/forward_command_controller/forward_command_controller.hh"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pongsim::ros2 {

Outcome<void> ForwardCommandController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  log_ = &setup.log;
  name_ = setup.ros.options().name;
  if (interface_ == "*") {
    const std::string joint = parameters.text("joint", "");
    if (joint.empty()) parameters.complain("'joint' is missing");
    for (const std::string& each : parameters.texts("interface_names")) names_.push_back(joint + "/" + each);
    if (names_.empty()) parameters.complain("'interface_names' is empty");
  } else {
    if (interface_.empty()) {
      interface_ = parameters.text("interface_name", "");
      if (interface_.empty()) parameters.complain("'interface_name' is missing");
    }
    for (const std::string& joint : parameters.texts("joints")) names_.push_back(joint + "/" + interface_);
    if (names_.empty()) parameters.complain("'joints' is empty");
  }
  commands_ =
      setup.subscribe<std_msgs::Float64MultiArray>("~/commands", [this](const auto& message) { receive(message); });
  return {};
}

void ForwardCommandController::receive(const std_msgs::Float64MultiArray& message) {
  // before it was activated
  if (handles_.empty()) return;
  const bool areFinite = std::ranges::all_of(message.data, [](double value) { return std::isfinite(value); });
  if (message.data.size() == names_.size() && areFinite) {
    values_ = message.data;
    hasWarned_ = false;
  } else if (!std::exchange(hasWarned_, true)) {
    log_->warning("controller '" + name_ + "': a command is ignored: " +
                  (areFinite ? "it has " + std::to_string(message.data.size()) + " numbers instead of " +
                                   std::to_string(names_.size())
                             : "it has a number that is not finite"));
  }
}

Outcome<void> ForwardCommandController::activate(const Loan& loan, Time) {
  handles_ = loan.commands;
  values_.reset();
  return {};
}

void ForwardCommandController::deactivate() {
  handles_.clear();
  values_.reset();
}

void ForwardCommandController::update(Time, double) {
  if (!values_) return;
  for (std::size_t i = 0; i < handles_.size(); ++i) handles_[i]->set((*values_)[i]);
}

void ForwardCommandController::transfer(StateArchive& archive) {
  archive(values_);
  archive.check(!values_ || values_->size() == names_.size());
}

}  // namespace pongsim::ros2
