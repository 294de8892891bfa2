#pragma once

#include <ignition/msgs/actuators.pb.h>
#include <ignition/msgs/double.pb.h>

#include <string>
#include <string_view>
#include <utility>

#include "pongsim/commands.hh"
#include "pongsim/control/command_topic.hh"
#include "pongsim/node.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A number commanded by a topic: the last value received, or the initial value from the file.
class Setpoint {
 public:
  /// Which numbers of an Actuators message are meant.
  enum class Kind { kPosition, kVelocity, kNormalized };

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

  /// Subscribes to one number of an ignition.msgs.Actuators topic. A message that is too short changes nothing; the
  /// first one is warned of.
  void listenToActuators(Node& node, const Logger& log, const std::string& topic, Kind kind, int index,
                         double initial) {
    value_ = initial_ = initial;
    const auto receive = [this, &log, kind, index](const ignition::msgs::Actuators& message) {
      const auto& values = kind == Kind::kPosition   ? message.position()
                           : kind == Kind::kVelocity ? message.velocity()
                                                     : message.normalized();
      if (index < values.size()) {
        value_ = values[index];
      } else if (!std::exchange(hasWarned_, true)) {
        log.warning("a command of " + std::to_string(values.size()) + " actuators has no value for actuator " +
                    std::to_string(index) + " and was ignored");
      }
    };
    command_ = node.subscribe<ignition::msgs::Actuators>(topic, receive, kCommands);
  }

  /// Subscribes where the parameters say.
  /// @param fallback The default topic of single numbers.
  void listen(const SystemContext& context, CommandTopic& topic, std::string_view fallback, Kind kind, double initial) {
    topic.check(context);
    const std::string name = topic.name(context, fallback);
    if (topic.usesActuators) {
      listenToActuators(context.node, context.log, name, kind, topic.actuator, initial);
    } else {
      listen(context.node, name, initial);
    }
  }

  double value() const { return value_; }
  void reset() {
    value_ = initial_;
    hasWarned_ = false;
  }
  void transfer(StateArchive& archive) { archive(value_); }

 private:
  double initial_ = 0;
  double value_ = 0;
  bool hasWarned_ = false;
  Subscription command_;
};

}  // namespace pongsim
