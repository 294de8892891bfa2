#include <ignition/msgs/wheel_slip_parameters_cmd.pb.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// A slip beyond this is equivalent to no friction [m/s/N].
constexpr double kLargestSlip = 1e6;

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
        wheels_.push_back(wheelOf(*element));
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

  /// Compliances have no unit, slips are in m/s/N: they are scaled by the current speed of the rim and by the wheel's
  /// load as given in the file. (K. Yoshida and H. Hamano, "Motion Dynamics of a Rover with Slip-Based Traction Model",
  /// ICRA 2002, equation 1.)
  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    for (Wheel& wheel : wheels_) {
      const double scale = wheel.radius * std::abs(wheel.joint.velocity()) / wheel.load;
      wheel.collision.setSlip(std::min(scale * wheel.now.lateral, kLargestSlip),
                              std::min(scale * wheel.now.longitudinal, kLargestSlip));
    }
  }

  void reset() override {
    for (Wheel& wheel : wheels_) wheel.now = wheel.atStart;
  }

  void transfer(StateArchive& archive) override {
    for (Wheel& wheel : wheels_) {
      archive(wheel.now.lateral);
      archive(wheel.now.longitudinal);
    }
  }

 private:
  struct Compliance {
    double lateral = 0;
    double longitudinal = 0;
  };
  struct Wheel {
    Link link;
    Collision collision;
    Joint joint;
    double radius;
    double load;
    Compliance atStart;
    Compliance now;
  };

  Wheel wheelOf(const Element& element) const {
    const Element::Attribute* attribute = element.attribute("link_name");
    if (attribute == nullptr) refuse(element, "<wheel> has no link_name", "write <wheel link_name=\"LINK\">");
    const std::optional<Link> found = model_->link(attribute->value);
    if (!found) {
      std::string names;
      for (const Link& other : model_->links()) names += (names.empty() ? "" : ", ") + std::string(other.name());
      throw Error({Severity::kError, attribute->position,
                   "link_name '" + attribute->value + "' is not a link of model '" + std::string(model_->name()) + "'",
                   "its links are " + names});
    }
    const Link link = *found;
    const std::string label = "link '" + attribute->value + "'";

    const std::vector<Collision> collisions = link.collisions();
    if (collisions.size() != 1) {
      refuse(element,
             label + " has " + std::to_string(collisions.size()) + " collisions: a slipping wheel must have one");
    }
    std::vector<Joint> joints = model_->joints();
    std::erase_if(joints, [&](const Joint& joint) { return joint.child().id() != link.id(); });
    if (joints.size() != 1 || joints[0].axisCount() == 0) {
      refuse(element, label + " is not the child of exactly one joint with an axis");
    }
    const Compliance compliance{atLeastZero(element, "slip_compliance_lateral"),
                                atLeastZero(element, "slip_compliance_longitudinal")};
    return {link,
            collisions[0],
            joints[0],
            aboveZero(element, "wheel_radius"),
            aboveZero(element, "wheel_normal_force"),
            compliance,
            compliance};
  }

  static double aboveZero(const Element& wheel, const char* name) {
    const std::optional<double> value = wheel.find<double>(name);
    if (!value) refuse(wheel, "<wheel> has no <" + std::string(name) + ">");
    if (!(*value > 0) || !std::isfinite(*value)) {
      refuse(*wheel.child(name), "<" + std::string(name) + "> must be above zero");
    }
    return *value;
  }

  static double atLeastZero(const Element& wheel, const char* name) {
    const double value = wheel.get<double>(name, 0);
    if (!(value >= 0) || !std::isfinite(value)) {
      refuse(*wheel.child(name), "<" + std::string(name) + "> must be zero or more");
    }
    return value;
  }

  void receive(const ignition::msgs::WheelSlipParametersCmd& command) {
    const Compliance wanted{command.slip_compliance_lateral(), command.slip_compliance_longitudinal()};
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
      if (isModel || isMeant(wheel.link.id().value, wheel.link.scopedName())) wheel.now = wanted;
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
