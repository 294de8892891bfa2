#include <ignition/msgs/double.pb.h>

#include <cmath>
#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Applies the force that it is told to a joint, until it is told another.
class ApplyJointForce : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Applies the force that it is told to a joint, until it is told another.",
                   Declaration::Place::kModel);
    declaration.parameter("joint_name", &jointName_, "", "joint of the model, with one axis").required();
    declaration.subscribes("/model/M/joint/J/cmd_force", "ignition.msgs.Double", "force [N] or torque [N m]");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    joint_ = requiredJoint(context.sdf, "joint_name", model);
    log_ = &context.log;
    const std::string topic =
        "/model/" + std::string(model.name()) + "/joint/" + std::string(joint_->name()) + "/cmd_force";
    command_ = context.node.subscribe<ignition::msgs::Double>(
        cleanTopic(topic), [this](const ignition::msgs::Double& message) { receive(message.data()); });
  }

  void preUpdate(const StepInfo& info) override {
    if (!info.paused && force_ != 0) joint_->addForce(force_);
  }

  void reset() override { force_ = 0; }

 private:
  void receive(double force) {
    if (std::isfinite(force)) {
      force_ = force;
    } else {
      log_->warning("a force that is not finite was ignored");
    }
  }

  std::string jointName_;
  std::optional<Joint> joint_;
  double force_ = 0;
  const Logger* log_ = nullptr;
  Subscription command_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ApplyJointForce, "ignition::gazebo::systems::ApplyJointForce",
                      "gz::sim::systems::ApplyJointForce");
