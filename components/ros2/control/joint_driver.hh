#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "ros2/control/control_block.hh"
#include "ros2/control/joint_commands.hh"

namespace pongsim::ros2 {

/// Drives joints like gz_ros2_control: to a position, with a velocity proportional to the remaining distance; at a
/// velocity; or with a force. Joints that mimic another follow it. If a joint has several commands, the one that
/// changed last counts. Joints without a command so far hold their position.
class JointDriver {
 public:
  struct Settings {
    /// Update rate of the controllers [Hz].
    double updateRate = 100;
    /// Fraction of the remaining distance that is covered in each of their periods.
    double positionGain = 0.1;
    bool holdsJoints = true;
  };

  /// @param model Must have the joints, each with an axis.
  JointDriver(const Model& model, std::vector<ControlledJoint> joints, const Settings& settings);

  enum class Interface { kNone, kPosition, kVelocity, kEffort };

  const std::vector<ControlledJoint>& joints() const { return controlled_; }
  const Joint& joint(std::size_t index) const { return driven_[index].joint; }

  /// @param commands One for each joint.
  void command(const std::vector<JointCommand>& commands);

  /// Lets a controller inside the simulation command a joint by an interface. `command` no longer does. Until the first
  /// value the joint is held, or without a force. Where it is commanded by several interfaces at once, velocity
  /// precedes position, and position effort, as in gz_ros2_control.
  void claim(std::size_t index, Interface interface);
  void release(std::size_t index, Interface interface);
  /// Sets the value of a claimed interface. Not a number: there is none. Absurdly large ones are limited.
  void set(std::size_t index, Interface interface, double value);
  /// @return The value of a claimed interface; not a number if there is none.
  double get(std::size_t index, Interface interface) const;

  /// Moves the joints to their initial positions; call between two steps.
  /// @return Why a joint can't be moved there, for each that can't.
  std::vector<std::string> begin();
  /// Call in each step before the physics.
  /// @param dt Length of the step.
  void drive(Time dt);
  /// Clears all commands.
  void reset();
  void transfer(StateArchive& archive);

 private:
  struct Driven {
    Joint joint;
    /// The joint that it mimics.
    std::optional<std::size_t> leader = std::nullopt;
    Interface interface = Interface::kNone;
    std::set<Interface> claimed = {};
    std::optional<double> position = std::nullopt;
    std::optional<double> velocity = std::nullopt;
    std::optional<double> effort = std::nullopt;

    const std::optional<double>& value(Interface of) const;
    std::optional<double>& value(Interface of) {
      return const_cast<std::optional<double>&>(std::as_const(*this).value(of));
    }
    void transfer(StateArchive& archive);
  };
  static void chooseInterface(Driven& driven);

  std::vector<ControlledJoint> controlled_;
  Settings settings_;
  std::vector<Driven> driven_;
};

}  // namespace pongsim::ros2
