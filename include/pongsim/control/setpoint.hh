#pragma once

#include <ignition/msgs/double.pb.h>

#include <string>

#include "pongsim/commands.hh"
#include "pongsim/node.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A number commanded by a topic: the last value received, or the initial value from the file.
class Setpoint {
 public:
  Setpoint() = default;
  // the subscription's callback has its address
  Setpoint(const Setpoint&) = delete;
  Setpoint& operator=(const Setpoint&) = delete;

  /// Subscribes to an ignition.msgs.Double topic.
  /// @param options Which numbers are refused with a warning: `kCommands` or `kForces`.
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
