#include <ignition/msgs/double.pb.h>

#include <cmath>
#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/pid.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr PidSettings kDefaults{.p = 1, .iMin = -1, .iMax = 1, .commandMin = -1000, .commandMax = 1000};

/// Turns a joint at the velocity that it is told.
class JointController : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Turns a joint at the velocity that it is told.", Declaration::Place::kModel);
    declaration.parameter("joint_name", &jointName_, "", "joint of the model, with one axis").required();
    declaration.parameter("topic", &topic_, "", "where commands come from").otherwise("/model/M/joint/J/cmd_vel");
    declaration.parameter("initial_velocity", &initialTarget_, "rad/s or m/s", "velocity until the first command");
    declaration.parameter("use_force_commands", &usesForce_, "", "a PID pushes the joint towards the velocity");
    declarePid(declaration, settings_, "N m or N");
    declaration.subscribes("<topic>", "ignition.msgs.Double", "velocity [rad/s or m/s]");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    joint_ = requiredJoint(context.sdf, "joint_name", model);
    log_ = &context.log;
    pid_ = Pid(settings_);
    target_ = initialTarget_;
    const std::string topic =
        topicOr(topic_, "/model/" + std::string(model.name()) + "/joint/" + std::string(joint_->name()) + "/cmd_vel");
    command_ = context.node.subscribe<ignition::msgs::Double>(
        topic, [this](const ignition::msgs::Double& message) { receive(message.data()); });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (usesForce_) {
      joint_->addForce(pid_.update(joint_->velocity() - target_, toSeconds(info.dt)));
    } else {
      joint_->setVelocityTarget(target_);
    }
  }

  void reset() override {
    pid_.reset();
    target_ = initialTarget_;
  }

  void transfer(StateArchive& archive) override {
    pid_.transfer(archive);
    archive(target_);
  }

 private:
  void receive(double target) {
    if (std::isfinite(target)) {
      target_ = target;
    } else {
      log_->warning("a velocity that is not finite was ignored");
    }
  }

  std::string jointName_;
  std::string topic_;
  bool usesForce_ = false;
  PidSettings settings_ = kDefaults;
  std::optional<Joint> joint_;
  Pid pid_;
  double initialTarget_ = 0;
  double target_ = 0;
  const Logger* log_ = nullptr;
  Subscription command_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::JointController, "ignition::gazebo::systems::JointController",
                      "gz::sim::systems::JointController");
