#pragma once

#include <ignition/msgs/double.pb.h>

#include <string>

#include "pongsim/commands.hh"
#include "pongsim/node.hh"
#include "pongsim/state_archive.hh"

namespace pongsim {

/// A number that a topic commands: what came last, or at first what the file says.
class Setpoint {
 public:
  Setpoint() = default;
  // the subscription holds on to it
  Setpoint(const Setpoint&) = delete;
  Setpoint& operator=(const Setpoint&) = delete;

  /// Listens for ignition.msgs.Double.
  /// @param options Which numbers are refused with a warning: those that are no commands, or no forces (`kForces`).
  void listen(Node& node, const std::string& topic, double initial, const SubscriptionOptions& options = kCommands) {
    value_ = initial_ = initial;
    command_ = node.subscribe<ignition::msgs::Double>(
        topic, [this](const ignition::msgs::Double& message) { value_ = message.data(); }, options);
  }

  double value() const { return value_; }
  void reset() { value_ = initial_; }
  void transfer(StateArchive& archive) { archive(value_); }

 private:
  double initial_ = 0;
  double value_ = 0;
  Subscription command_;
};

}  // namespace pongsim
