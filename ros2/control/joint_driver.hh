#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "ros2/control/control_block.hh"
#include "ros2/control/joint_commands.hh"

namespace pongsim::ros2 {

/// Drives joints as gz_ros2_control does: to a position by a velocity that is proportional to what is left of the way,
/// at a velocity, or with a force; those that follow another one after it. Of several ways the one counts whose command
/// changed last. What nobody has commanded yet is held in its place.
class JointDriver {
 public:
  struct Settings {
    /// Of the controllers [Hz].
    double updateRate = 100;
    /// Share of the way that is left that is made up for in each of their periods.
    double positionGain = 0.1;
    bool holdsJoints = true;
  };

  /// @param model Must have the joints, each with an axis.
  JointDriver(const Model& model, std::vector<ControlledJoint> joints, const Settings& settings);

  const std::vector<ControlledJoint>& joints() const { return controlled_; }
  const Joint& joint(std::size_t index) const { return driven_[index].joint; }

  /// @param commands One for each joint.
  void command(const std::vector<JointCommand>& commands);

  /// Puts the joints to where they begin; to be called between two steps.
  /// @return Why one can't be put there.
  std::vector<std::string> begin();
  /// In each step before the physics.
  /// @param dt Length of the step.
  void drive(Time dt);
  /// Forgets what was commanded.
  void reset();
  void transfer(StateArchive& archive);

 private:
  enum class Way { kNone, kPosition, kVelocity, kEffort };
  struct Driven {
    Joint joint;
    /// The one that it follows.
    std::optional<std::size_t> leader = std::nullopt;
    Way way = Way::kNone;
    std::optional<double> position = std::nullopt;
    std::optional<double> velocity = std::nullopt;
    std::optional<double> effort = std::nullopt;

    void transfer(StateArchive& archive);
  };

  std::vector<ControlledJoint> controlled_;
  Settings settings_;
  std::vector<Driven> driven_;
};

}  // namespace pongsim::ros2
