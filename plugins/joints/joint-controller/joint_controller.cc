#include <string>
#include <vector>

#include "pongsim/control/command_topic.hh"
#include "pongsim/control/pid.hh"
#include "pongsim/control/setpoint.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr PidSettings kDefaults{.p = 1, .iMin = -1, .iMax = 1, .commandMin = -1000, .commandMax = 1000};

/// Drives a joint at a commanded velocity.
class JointController : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Drives a joint at a commanded velocity.", Declaration::Place::kModel);
    declaration
        .parameter("joint_name", &jointNames_, "",
                   "joint of the model, with one axis; further ones of the same kind are driven like the first")
        .required();
    command_.declare(declaration, "/model/M/joint/J/cmd_vel");
    declaration.parameter("initial_velocity", &initialTarget_, "rad/s or m/s", "velocity until the first command");
    declaration.parameter("use_force_commands", &usesForce_, "", "drives the joint by forces from a PID controller");
    declarePid(declaration, settings_, "N m or N");
    declaration.parameter(
        "disable_braking", &isFreewheeling_, "",
        "a force never brakes: a joint that is faster than the command, or has no command, runs free");
    declaration.element("control_type", "no effect, as in Gazebo");
    declaration.subscribes("<topic>", "ignition.msgs.Double", "velocity [rad/s or m/s]");
    declaration.subscribes("<topic>", "ignition.msgs.Actuators",
                           "with `<use_actuator_msg>`: `velocity[actuator_number]` [rad/s or m/s]");
  }

  void configure(const SystemContext& context) override {
    joints_ = requiredJoints(context.sdf, "joint_name", *context.model);
    pid_ = Pid(settings_);
    target_.listen(
        context, command_,
        "/model/" + std::string(context.model->name()) + "/joint/" + std::string(joints_[0].name()) + "/cmd_vel",
        Setpoint::Kind::kVelocity, initialTarget_);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (!usesForce_) {
      for (Joint& joint : joints_) joint.setVelocityTarget(target_.value());
      return;
    }
    const double error = joints_[0].velocity() - target_.value();
    const bool isTooSlow = target_.value() != 0 && error * target_.value() <= 0;
    if (isFreewheeling_ && !isTooSlow) return;
    const double force = pid_.update(error, toSeconds(info.dt));
    for (Joint& joint : joints_) joint.addForce(force);
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
  bool usesForce_ = false;
  bool isFreewheeling_ = false;
  PidSettings settings_ = kDefaults;
  std::vector<Joint> joints_;
  Pid pid_;
  double initialTarget_ = 0;
  Setpoint target_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::JointController, "ignition::gazebo::systems::JointController",
                      "gz::sim::systems::JointController");
