#include <optional>
#include <string>

#include "hull.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Applies the forces of the air to the hull of an airship.
class LighterThanAirDynamics : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Applies the forces of the air to the hull of an airship.", Declaration::Place::kModel);
    declaration.parameter("link_name", &linkName_, "", "link of the hull, whose nose is ahead along x").required();
    declaration.parameter("air_density", &hull_.density, "kg/m^3", "density of the air").above(0);
    const auto coefficient = [&](const char* name, double& value, const char* unit, const char* text) {
      declaration.parameter(name, &value, unit, text).required();
    };
    coefficient("force_inviscid_coeff", hull_.inviscidForce, "m^2", "coefficient of the inviscid flow's force");
    coefficient("force_viscous_coeff", hull_.viscousForce, "m^2", "coefficient of the viscous flow's force");
    coefficient("moment_inviscid_coeff", hull_.inviscidMoment, "m^3", "coefficient of the inviscid flow's moment");
    coefficient("moment_viscous_coeff", hull_.viscousMoment, "m^3", "coefficient of the viscous flow's moment");
    coefficient("eps_v", hull_.separation, "m", "distance behind the origin at which the flow ceases to be potential");
    coefficient("axial_drag_coeff", hull_.axialDrag, "m^2", "drag along the hull by dynamic pressure");
  }

  void configure(const SystemContext& context) override {
    link_ = requiredLink(context.sdf, "link_name", *context.model);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const Quaternion R_WorldLink = link_->pose().rotation;
    const Quaternion R_LinkWorld = R_WorldLink.conjugate();
    const Wrench local =
        hullWrench(hull_, R_LinkWorld * link_->linearVelocity(), R_LinkWorld * link_->angularVelocity());
    // at speeds whose square overflows
    if (!local.force.allFinite() || !local.torque.allFinite()) return;
    link_->addWrench(R_WorldLink * local.force, R_WorldLink * local.torque);
  }

 private:
  std::string linkName_;
  HullSettings hull_;
  std::optional<Link> link_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LighterThanAirDynamics, "gz::sim::systems::LighterThanAirDynamics",
                      "ignition::gazebo::systems::LighterThanAirDynamics");
