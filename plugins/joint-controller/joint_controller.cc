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
  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Model model = requiredModel(context, "JointController");
    joint_ = requiredJoint(sdf, "joint_name", model);
    log_ = &context.log;
    usesForce_ = sdf.get("use_force_commands", false);
    pid_ = Pid(readPidSettings(sdf, kDefaults));
    initialTarget_ = target_ = sdf.get("initial_velocity", 0.0);
    const std::string topic = topicParameter(
        sdf, "topic", "/model/" + std::string(model.name()) + "/joint/" + std::string(joint_->name()) + "/cmd_vel");
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

  std::optional<Joint> joint_;
  bool usesForce_ = false;
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
