#include <optional>
#include <string>

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
    declaration.parameter("joint_name", &jointName_, "", "joint of the model, with one axis").required();
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/joint/J/cmd_vel");
    declaration.parameter("initial_velocity", &initialTarget_, "rad/s or m/s", "velocity until the first command");
    declaration.parameter("use_force_commands", &usesForce_, "", "drives the joint by forces from a PID controller");
    declarePid(declaration, settings_, "N m or N");
    declaration.subscribes("<topic>", "ignition.msgs.Double", "velocity [rad/s or m/s]");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    joint_ = requiredJoint(context.sdf, "joint_name", model);
    pid_ = Pid(settings_);
    const std::string topic =
        topicOr(topic_, "/model/" + std::string(model.name()) + "/joint/" + std::string(joint_->name()) + "/cmd_vel");
    target_.listen(context.node, topic, initialTarget_);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (usesForce_) {
      joint_->addForce(pid_.update(joint_->velocity() - target_.value(), toSeconds(info.dt)));
    } else {
      joint_->setVelocityTarget(target_.value());
    }
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
  std::string jointName_;
  std::string topic_;
  bool usesForce_ = false;
  PidSettings settings_ = kDefaults;
  std::optional<Joint> joint_;
  Pid pid_;
  double initialTarget_ = 0;
  Setpoint target_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::JointController, "ignition::gazebo::systems::JointController",
                      "gz::sim::systems::JointController");
