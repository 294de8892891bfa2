#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/outcome.hh"
#include "pongsim/state/state_archive.hh"
#include "ros2/control/hardware_interfaces.hh"
#include "ros2/controllers/controller.hh"
#include "ros2/controllers/controller_parameters.hh"
#include "ros2/controllers/parameter_files.hh"
#include "ros2/controllers/remaps.hh"
#include "ros2/node/node.hh"
#include "ros2/node/parameters.hh"

namespace pongsim::ros2 {

/// Loads, configures, activates and updates the controllers of a robot, as ros2_control's controller_manager does. Its
/// node has that node's parameters, and each controller a node of its own. For the simulation's thread.
class ControllerManager {
 public:
  enum class State { kUnconfigured, kInactive, kActive };

  struct Options {
    /// "controller_manager"
    std::string name;
    /// "/" or "/robot"
    std::string nameSpace = "/";
    ParameterFiles files;
    Remaps remaps;
    Frames frames;
    bool tellsTransforms = true;
    /// Of the updates [Hz].
    double rate = 100;
  };

  /// A controller that has been loaded.
  struct Loaded {
    std::string name;
    std::string type;
    State state = State::kUnconfigured;
    Controller::Interfaces wanted;
    Controller::Loan loan;
    /// [Hz]; 0: that of the manager.
    double rate = 0;
    /// Commands that it holds.
    std::vector<std::string> claimed;

    Remaps remaps;
    std::optional<RosNode> node;
    ControllerParameters parameters;
    std::optional<Parameters> parameterServices;
    std::unique_ptr<Controller> controller;
    Time last{0};
  };

  /// @param beside A node of the participant that its nodes belong to.
  /// @param hardware Must outlive it, like `simulation` and `log`.
  ControllerManager(RosNode& beside, HardwareInterfaces& hardware, const Model& model, Node& simulation,
                    const Logger& log, Options options);
  ~ControllerManager();
  ControllerManager(const ControllerManager&) = delete;
  ControllerManager& operator=(const ControllerManager&) = delete;

  RosNode& node() { return node_; }
  /// @return "/robot/controller_manager"
  std::string nodeName() const { return node_.fullName(); }
  HardwareInterfaces& hardware() { return hardware_; }
  const HardwareInterfaces& hardware() const { return hardware_; }
  double rate() const { return options_.rate; }
  Time now() const { return now_; }
  /// In the order of loading.
  const std::list<Loaded>& controllers() const { return controllers_; }

  /// @return The controllers and classes that the parameter files name, except for those that are not known here.
  std::vector<std::pair<std::string, std::string>> unknownTypes() const;

  Outcome<void> load(const std::string& name);
  Outcome<void> configure(const std::string& name);
  /// An inactive controller is unconfigured again.
  Outcome<void> cleanUp(const std::string& name);
  Outcome<void> unload(const std::string& name);
  /// @param isStrict Whether nothing is switched if one of them can't be.
  Outcome<void> switchTo(std::vector<std::string> activate, std::vector<std::string> deactivate, bool isStrict);

  /// ROS topics that active controllers publish instead of the simulation.
  std::vector<std::string> replacedTopics() const;
  /// Changes with what the functions above do.
  std::uint64_t version() const { return version_; }

  /// Handles requests and messages that have arrived. Call it between two steps, also while paused.
  /// @return The number of them.
  std::size_t dispatch();
  /// Updates the active controllers where they are due. Call it after each step.
  void update(Time now);
  void reset();
  void transfer(StateArchive& archive);

 private:
  Loaded* find(const std::string& name);
  std::optional<std::string> parameterText(const std::string& name) const;
  std::vector<std::string> parameterTexts(const std::string& name) const;
  ParameterValues valuesFor(const std::string& controller, std::string& error) const;
  std::string typeOf(const std::string& controller, std::string& error) const;
  Outcome<Controller::Loan> loanFor(const Loaded& controller, const std::vector<std::string>& freed);
  Outcome<void> activate(Loaded& controller);
  void deactivate(Loaded& controller);
  std::function<builtin_interfaces::Time()> clock();

  Options options_;
  HardwareInterfaces& hardware_;
  Model model_;
  Node& simulation_;
  const Logger& log_;
  RosNode node_;
  Parameters parameters_;
  std::list<Loaded> controllers_;
  Time now_{0};
  Time last_{0};
  std::uint64_t version_ = 1;
};

}  // namespace pongsim::ros2
