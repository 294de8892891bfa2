#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/outcome.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "ros2/control/hardware_interfaces.hh"
#include "ros2/controllers/controller_parameters.hh"
#include "ros2/controllers/remaps.hh"
#include "ros2/node/node.hh"
#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

/// What a controller is given. All references outlive it.
struct ControllerSetup {
  /// The controller's own node.
  RosNode& ros;
  const Remaps& remaps;
  ControllerParameters& parameters;
  const Frames& frames;
  Node& simulation;
  const Model& model;
  const Logger& log;
  std::function<Time()> now;
  /// Of its updates [Hz].
  double rate = 100;
  /// Whether the simulation publishes the robot's frames on /tf.
  bool tellsTransforms = true;

  /// @param topic As in `RosNode::advertise`, before remapping; the same below.
  template <Structure Message>
  std::unique_ptr<RosPublisher> advertise(const std::string& topic, const Qos& qos = kDefaultQos) const {
    return ros.advertise<Message>(remaps.apply(ros, topic), qos);
  }

  /// @param received Called between two steps, on the simulation's thread.
  template <Structure Message>
  std::unique_ptr<RosSubscription> subscribe(const std::string& topic,
                                             std::function<void(const Message&)> received) const {
    const auto shared = std::make_shared<std::function<void(const Message&)>>(std::move(received));
    return ros.subscribe<Message>(remaps.apply(ros, topic), [shared, &mailbox = ros.mailbox()](const Message& message) {
      mailbox.post([shared, message] { (*shared)(message); });
    });
  }
};

/// A controller of ros2_control, which commands joints or publishes their state. For the simulation's thread.
class Controller {
 public:
  /// The interfaces that it uses while it is active.
  struct Interfaces {
    std::vector<std::string> commands = {};
    std::vector<std::string> states = {};
    /// Whether it reads all states instead.
    bool allStates = false;
  };
  /// These interfaces, in the order of `Interfaces`.
  struct Loan {
    std::vector<const HardwareInterfaces::Command*> commands;
    std::vector<const HardwareInterfaces::State*> states;
  };

  virtual ~Controller() = default;

  /// Reads its parameters and opens its topics. Errors in `ControllerParameters` need not be returned.
  virtual Outcome<void> configure(const ControllerSetup& setup) = 0;
  virtual Interfaces interfaces() const = 0;
  /// @return ROS topics that it publishes instead of the simulation.
  virtual std::vector<std::string> replacedTopics() const { return {}; }
  /// @param loan Valid until `deactivate`.
  virtual Outcome<void> activate(const Loan& loan, Time now) = 0;
  virtual void deactivate() = 0;
  /// @param period Time since the last update, above zero [s].
  virtual void update(Time now, double period) = 0;
  /// The world was reset; it stays active.
  virtual void reset() = 0;
  /// Saves or restores what is not a parameter; for an active controller.
  virtual void transfer(StateArchive& archive) = 0;
};

}  // namespace pongsim::ros2
