#include <ignition/msgs/wheel_slip_parameters_cmd.pb.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "slipping_wheel.hh"

namespace pongsim {

namespace {

/// Makes wheels slip depending on their load and rim speed.
class WheelSlip : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Makes wheels slip depending on their load and rim speed.", Declaration::Place::kModel);
    declaration
        .element(
            "wheel",
            "a wheel: its attribute `link_name` names a link with one collision and one joint on which it turns; may "
            "be "
            "repeated. It contains `wheel_radius` [m] and `wheel_normal_force`, the load [N], both above 0, and "
            "`slip_compliance_lateral` (along the wheel's axis) and `slip_compliance_longitudinal` (across it), both 0 "
            "by default: slip, as a fraction of the rim's speed, per friction force, as a fraction of the load")
        .required();
    declaration.subscribes(
        "/world/W/wheel_slip", "ignition.msgs.WheelSlipParametersCmd",
        "new slip compliances of a wheel, or of all wheels of a model, by name (`MODEL::LINK`) or id; "
        "every world also has a service of this name");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    model_ = context.model;
    const std::vector<const Element*> elements = context.sdf.childrenNamed("wheel");
    for (const Element* element : elements) {
      try {
        const SlippingWheel wheel = slippingWheel(*element, *model_);
        wheels_.push_back({wheel, wheel.compliance});
      } catch (const Error& error) {
        if (elements.size() == 1) throw;
        const Diagnostic& diagnostic = error.diagnostic();
        context.diagnostics.warning(diagnostic.position, "a <wheel> is left out: " + diagnostic.message,
                                    diagnostic.hint);
      }
    }
    if (wheels_.empty()) refuse(context.sdf, "none of the <wheel>s can be used");
    commands_ = context.node.subscribe<ignition::msgs::WheelSlipParametersCmd>(
        cleanTopic("/world/" + std::string(context.world.name()) + "/wheel_slip"),
        [this](const ignition::msgs::WheelSlipParametersCmd& command) { receive(command); }, kCommands);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    for (Wheel& wheel : wheels_) wheel.self.slip(wheel.now);
  }

  void reset() override {
    for (Wheel& wheel : wheels_) wheel.now = wheel.self.compliance;
  }

  void transfer(StateArchive& archive) override {
    for (Wheel& wheel : wheels_) {
      archive(wheel.now.lateral);
      archive(wheel.now.longitudinal);
    }
  }

 private:
  struct Wheel {
    SlippingWheel self;
    SlipCompliance now;
  };

  void receive(const ignition::msgs::WheelSlipParametersCmd& command) {
    const SlipCompliance wanted{command.slip_compliance_lateral(), command.slip_compliance_longitudinal()};
    for (const double value : {wanted.lateral, wanted.longitudinal}) {
      if (value >= 0) continue;
      log_->warning("slip compliances below zero were ignored");
      return;
    }
    const ignition::msgs::Entity& entity = command.entity();
    const auto isMeant = [&entity](std::uint64_t id, const std::string& name) {
      return entity.id() != 0 ? entity.id() == id : entity.name() == name;
    };
    const bool isModel = isMeant(model_->id().value, model_->scopedName());
    for (Wheel& wheel : wheels_) {
      if (isModel || isMeant(wheel.self.link.id().value, wheel.self.link.scopedName())) wheel.now = wanted;
    }
  }

  std::optional<Model> model_;
  std::vector<Wheel> wheels_;
  const Logger* log_ = nullptr;
  Subscription commands_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::WheelSlip, "ignition::gazebo::systems::WheelSlip", "gz::sim::systems::WheelSlip");
