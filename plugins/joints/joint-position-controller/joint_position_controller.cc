#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/control/command_topic.hh"
#include "pongsim/control/pid.hh"
#include "pongsim/control/setpoint.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr PidSettings kDefaults{
    .p = 1, .i = 0.1, .d = 0.01, .iMin = -1, .iMax = 1, .commandMin = -1000, .commandMax = 1000};

/// Moves a joint to a commanded position.
class JointPositionController : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Moves a joint to a commanded position.", Declaration::Place::kModel);
    declaration
        .parameter("joint_name", &jointNames_, "",
                   "joint of the model, with one axis; further ones of the same kind are driven like the first")
        .required();
    declaration.parameter("joint_index", &axis_, "", "axis of the joint").atLeast(0);
    command_.declare(declaration, "/model/M/joint/J/0/cmd_pos, with the index");
    declaration.parameter("initial_position", &initialTarget_, "rad or m", "position until the first command");
    declaration.parameter("use_velocity_commands", &usesVelocity_, "",
                          "sets the velocity directly, at most `cmd_max` [rad/s or m/s]");
    declarePid(declaration, settings_, "N m or N");
    declaration.subscribes("<topic>", "ignition.msgs.Double", "position [rad or m]");
    declaration.subscribes("<topic>", "ignition.msgs.Actuators",
                           "with `<use_actuator_msg>`: `position[actuator_number]` [rad or m]");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    joints_ = requiredJoints(sdf, "joint_name", *context.model);
    for (const Joint& joint : joints_) {
      if (axis_ < joint.axisCount()) continue;
      refuse(*sdf.child("joint_index"),
             "joint '" + std::string(joint.name()) + "' has no axis " + std::to_string(axis_));
    }
    pid_ = Pid(settings_);
    // as in Fortress, it counts only if it is given
    if (sdf.child("cmd_max") != nullptr) largestVelocity_ = settings_.commandMax;
    target_.listen(context, command_,
                   "/model/" + std::string(context.model->name()) + "/joint/" + std::string(joints_[0].name()) + "/" +
                       std::to_string(axis_) + "/cmd_pos",
                   Setpoint::Kind::kPosition, initialTarget_);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    const double error = joints_[0].position(axis_) - target_.value();
    if (!usesVelocity_) {
      const double force = pid_.update(error, dt);
      for (Joint& joint : joints_) joint.addForce(force, axis_);
      return;
    }
    double velocity = -error / dt;
    if (largestVelocity_ && std::abs(velocity) > *largestVelocity_) {
      velocity = std::copysign(*largestVelocity_, velocity);
    }
    velocity = std::clamp(velocity, -kLargestCommand, kLargestCommand);
    for (Joint& joint : joints_) joint.setVelocityTarget(velocity, axis_);
  }

  void reset() override {
    pid_.reset();
    target_.reset();
  }

  void transfer(StateArchive& archive) override {
    archive(pid_);
    archive(target_);
  }

 private:
  std::vector<std::string> jointNames_;
  CommandTopic command_;
  PidSettings settings_ = kDefaults;
  std::vector<Joint> joints_;
  int axis_ = 0;
  Pid pid_;
  bool usesVelocity_ = false;
  std::optional<double> largestVelocity_;
  double initialTarget_ = 0;
  Setpoint target_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::JointPositionController, "ignition::gazebo::systems::JointPositionController",
                      "gz::sim::systems::JointPositionController");
