#pragma once

#include <ignition/msgs/double.pb.h>

#include <cmath>
#include <string>
#include <utility>

#include "pongsim/log.hh"
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
  /// @param what What the number is, for a warning about one that is not finite and is ignored: "a velocity".
  void listen(Node& node, const std::string& topic, double initial, std::string what, const Logger& log) {
    value_ = initial_ = initial;
    command_ = node.subscribe<ignition::msgs::Double>(
        topic, [this, &log, what = std::move(what)](const ignition::msgs::Double& message) {
          if (std::isfinite(message.data())) {
            value_ = message.data();
          } else {
            log.warning(what + " that is not finite was ignored");
          }
        });
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
