#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "airframe.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Applies the forces and moments of the air to a whole aircraft.
class AdvancedLiftDrag : public System {
 public:
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    SixCoefficients control;
    for (const Surface& surface : surfaces_) control.add(surface.joint.position() * kDegree, surface.perDegree);
    const Quaternion R_WorldLink = link_->pose().rotation;
    const Vector3 arm = R_WorldLink * center_;
    const Vector3 velocity = link_->linearVelocity() + link_->angularVelocity().cross(arm) - world_->wind();
    const Quaternion R_LinkWorld = R_WorldLink.conjugate();
    const Wrench local =
        airframeWrench(airframe_, R_LinkWorld * velocity, R_LinkWorld * link_->angularVelocity(), control);
    const Vector3 force = R_WorldLink * local.force;
    const Vector3 torque = R_WorldLink * local.torque + arm.cross(force);
    // at speeds whose square overflows
    if (force.allFinite() && torque.allFinite()) link_->addWrench(force, torque);
  }

 private:
  static constexpr double kDegree = 180 / std::numbers::pi;

  /// A control surface.
  struct Surface {
    Joint joint;
    /// Change of the coefficients per degree of the joint.
    SixCoefficients perDegree;
  };

  void declareDerivatives(Declaration& declaration);
  Surface surfaceOf(const Element& element, const Model& model) const;

  std::string linkName_;
  Airframe airframe_;
  Vector3 center_ = Vector3::Zero();
  int surfaceCount_ = 0;

  const World* world_ = nullptr;
  std::optional<Link> link_;
  std::vector<Surface> surfaces_;
};

/// Where the derivatives of each coefficient are, by its name in the file.
constexpr std::pair<const char*, double SixCoefficients::*> kCoefficients[] = {
    {"CD", &SixCoefficients::drag},   {"CY", &SixCoefficients::side},   {"CL", &SixCoefficients::lift},
    {"Cell", &SixCoefficients::roll}, {"Cem", &SixCoefficients::pitch}, {"Cen", &SixCoefficients::yaw}};

void AdvancedLiftDrag::declare(Declaration& declaration) {
  declaration.is("Applies the forces and moments of the air to an aircraft, with the coefficients of a vortex model.",
                 Declaration::Place::kModel);
  declaration.parameter("link_name", &linkName_, "", "link of the airframe").required();
  declaration.parameter("area", &airframe_.area, "m^2", "area of the wing").above(0);
  declaration.parameter("AR", &airframe_.aspectRatio, "", "aspect ratio").above(0).required();
  declaration.parameter("mac", &airframe_.chord, "m", "mean aerodynamic chord").atLeast(0).otherwise("area / span");
  declaration.parameter("eff", &airframe_.efficiency, "", "Oswald's efficiency factor").above(0).required();
  declaration.parameter("air_density", &airframe_.density, "kg/m^3", "density of the air").above(0);
  declaration.parameter("cp", &center_, "m", "reference point, in the link frame");
  declaration.parameter("forward", &airframe_.forward, "", "forward direction, in the link frame");
  declaration.parameter("upward", &airframe_.upward, "", "upward direction, in the link frame");
  declaration.parameter("alpha_stall", &airframe_.stallAngle, "rad", "angle of attack at which the wing stalls")
      .atLeast(0);
  declaration.parameter("CL0", &airframe_.lift0, "", "lift coefficient at an angle of attack of zero");
  declaration.parameter("CD0", &airframe_.drag0, "", "drag coefficient without lift");
  declareDerivatives(declaration);
  declaration.element(
      "control_surface",
      "a control surface: `name` of its joint, `direction` (1 or -1), and the changes of the coefficients per degree, "
      "`CD_ctrl`, `CY_ctrl`, `CL_ctrl`, `Cell_ctrl`, `Cem_ctrl`, `Cen_ctrl`; may be repeated");
  declaration.parameter("num_ctrl_surfaces", &surfaceCount_, "", "how many of them count").atLeast(0);
  for (const char* name :
       {"a0", "Cem0", "Cema", "Cema_stall", "CLa_stall", "CDa_stall", "radial_symmetry", "control_joint_rad_to_cl"}) {
    declaration.element(name, "no effect, as in Gazebo");
  }
}

void AdvancedLiftDrag::declareDerivatives(Declaration& declaration) {
  // Gazebo has no slopes of the drag with angles; it reads that of the pitching moment with alpha without using it
  const auto isRead = [](char letter, double SixCoefficients::*member) {
    if (letter == 'a' && member == &SixCoefficients::pitch) return false;
    return (letter != 'a' && letter != 'b') || member != &SixCoefficients::drag;
  };
  const auto add = [&](char letter, SixCoefficients& derivatives, const char* names, const char* unit,
                       const char* text) {
    for (const auto& [name, member] : kCoefficients) {
      if (!isRead(letter, member)) continue;
      declaration.parameter(name + std::string(1, letter), &(derivatives.*member), unit, text).inFamily(names);
    }
  };
  add('a', airframe_.alpha, "C{Y,L,ell,en}a", "1/rad",
      "slope with the angle of attack, of the side force (Y), the lift (L), and the moments of roll and yaw (ell, en)");
  add('b', airframe_.beta, "C{Y,L,ell,em,en}b", "1/rad", "slope with the sideslip; em: of the moment of pitch");
  add('p', airframe_.p, "C{D,Y,L,ell,em,en}p", "", "slope with the roll rate times span / (2 speed)");
  add('q', airframe_.q, "C{D,Y,L,ell,em,en}q", "", "slope with the pitch rate times mac / (2 speed)");
  add('r', airframe_.r, "C{D,Y,L,ell,em,en}r", "", "slope with the yaw rate times span / (2 speed)");
}

AdvancedLiftDrag::Surface AdvancedLiftDrag::surfaceOf(const Element& element, const Model& model) const {
  Surface surface{.joint = requiredJoint(element, "name", model), .perDegree = {}};
  const double direction = element.get<double>("direction", 1);
  for (const auto& [name, member] : kCoefficients) {
    surface.perDegree.*member = direction * element.get<double>(name + std::string("_ctrl"), 0);
  }
  return surface;
}

void AdvancedLiftDrag::configure(const SystemContext& context) {
  const Element& sdf = context.sdf;
  world_ = &context.world;
  link_ = requiredLink(sdf, "link_name", *context.model);
  const std::vector<const Element*> elements = sdf.childrenNamed("control_surface");
  for (const Element* element : elements) {
    if (surfaces_.size() < static_cast<std::size_t>(surfaceCount_)) {
      surfaces_.push_back(surfaceOf(*element, *context.model));
    }
  }
  if (elements.size() != static_cast<std::size_t>(surfaceCount_)) {
    context.diagnostics.warning(sdf.position, "<num_ctrl_surfaces> is " + std::to_string(surfaceCount_) +
                                                  ", but there are " + std::to_string(elements.size()) +
                                                  " <control_surface>s: " + std::to_string(surfaces_.size()) +
                                                  " have an effect");
  }
  const auto refuseVector = [&sdf](const char* name, const char* rule) {
    const Element* element = sdf.child(name);
    refuse(element != nullptr ? *element : sdf, std::string("<") + name + "> " + rule);
  };
  if (!(airframe_.forward.norm() > 0)) refuseVector("forward", "must have a direction");
  if (!(airframe_.upward.norm() > 0)) refuseVector("upward", "must have a direction");
  airframe_.forward.normalize();
  airframe_.upward.normalize();
  if (airframe_.forward.cross(airframe_.upward).norm() < 1e-6) {
    refuseVector("upward", "is parallel to <forward>; it must have a component across it");
  }
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::AdvancedLiftDrag, "gz::sim::systems::AdvancedLiftDrag",
                      "ignition::gazebo::systems::AdvancedLiftDrag");
