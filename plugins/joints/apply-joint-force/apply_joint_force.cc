#include <optional>
#include <string>

#include "pongsim/control/setpoint.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Applies a commanded force to a joint, until the next command.
class ApplyJointForce : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Applies a commanded force to a joint, until the next command.", Declaration::Place::kModel);
    declaration.parameter("joint_name", &jointName_, "", "joint of the model, with one axis").required();
    declaration.subscribes("/model/M/joint/J/cmd_force", "ignition.msgs.Double", "force [N] or torque [N m]");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    joint_ = requiredJoint(context.sdf, "joint_name", model);
    const std::string topic =
        "/model/" + std::string(model.name()) + "/joint/" + std::string(joint_->name()) + "/cmd_force";
    force_.listen(context.node, cleanTopic(topic), 0, kForces);
  }

  void preUpdate(const StepInfo& info) override {
    if (!info.paused && force_.value() != 0) joint_->addForce(force_.value());
  }

  void reset() override { force_.reset(); }

  void transfer(StateArchive& archive) override { archive(force_); }

 private:
  std::string jointName_;
  std::optional<Joint> joint_;
  Setpoint force_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ApplyJointForce, "ignition::gazebo::systems::ApplyJointForce",
                      "gz::sim::systems::ApplyJointForce");
