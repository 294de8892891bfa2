#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "airfoil.hh"
#include "carried_link.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Applies lift and drag to a link, such as a wing, a fin or a propeller blade.
class LiftDrag : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Applies lift and drag to a link, such as a wing, a fin or a propeller blade.",
                   Declaration::Place::kModel);
    declaration.parameter("link_name", &linkName_, "", "link; in a nested model `inner::link`").required();
    declaration.parameter("area", &airfoil_.area, "m^2", "area of the surface").atLeast(0);
    declaration.parameter("air_density", &airfoil_.density, "kg/m^3", "density of the fluid").above(0);
    declaration.parameter("a0", &airfoil_.zeroAngle, "rad", "angle of attack at zero incidence");
    declaration.parameter("cla", &airfoil_.liftSlope, "1/rad", "slope of the lift coefficient");
    declaration.parameter("cda", &airfoil_.dragSlope, "1/rad", "slope of the drag coefficient");
    declaration.parameter("alpha_stall", &airfoil_.stallAngle, "rad", "angle of attack at which the wing stalls")
        .atLeast(0);
    declaration.parameter("cla_stall", &airfoil_.liftSlopeStalled, "1/rad",
                          "slope of the lift coefficient after the stall");
    declaration.parameter("cda_stall", &airfoil_.dragSlopeStalled, "1/rad",
                          "slope of the drag coefficient after the stall");
    declaration.parameter("cma", &airfoil_.momentSlope, "1/rad",
                          "slope of the moment coefficient; here and below: no effect in a plugin for Fortress");
    declaration.parameter("cma_stall", &airfoil_.momentSlopeStalled, "1/rad",
                          "slope of the moment coefficient after the stall");
    declaration.parameter("cp", &center_, "m", "point of application, in the link frame");
    declaration.parameter("forward", &airfoil_.forward, "", "forward direction, in the link frame");
    declaration.parameter("upward", &airfoil_.upward, "", "upward direction, in the link frame");
    declaration.parameter(
        "radial_symmetry", &airfoil_.isRound, "",
        "a body of revolution about `<forward>`, not a wing: the flow determines the direction of its lift");
    declaration.parameter("control_joint_name", &jointName_, "",
                          "joint of a control surface; in a nested model `inner::joint`");
    declaration.parameter("control_joint_rad_to_cl", &liftOfJoint_, "1/rad or 1/m",
                          "change of the lift coefficient with the joint's angle");
    declaration.parameter("cm_delta", &momentOfJoint_, "1/rad or 1/m",
                          "change of the moment coefficient with the joint's angle");
    declaration.parameter("reversible", &isReversible_, "", "there is a force in a flow from behind, too");
  }

  void configure(const SystemContext& context) override;

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const Quaternion R_WorldLink = link_->pose().rotation;
    const Vector3 arm = R_WorldLink * center_;
    Vector3 velocity = carried_->linearVelocity() + link_->angularVelocity().cross(arm);
    if (isLater_) velocity -= world_->wind();
    const Vector3 v_Link = R_WorldLink.conjugate() * velocity;
    const double angle = joint_ ? joint_->position() : 0;
    const Vector3 force = R_WorldLink * airfoilForce(airfoil_, v_Link, liftOfJoint_ * angle);
    Vector3 torque = arm.cross(force);
    if (isLater_) torque += R_WorldLink * airfoilMoment(airfoil_, v_Link, momentOfJoint_ * angle);
    // at speeds whose square overflows
    if (force.allFinite() && torque.allFinite()) link_->addWrench(force, torque);
  }

  // joints may have been added or removed
  void worldChanged() override { carried_.emplace(*link_); }
  void reset() override { carried_.emplace(*link_); }

 private:
  std::string linkName_;
  std::string jointName_;
  AirfoilSettings airfoil_;
  Vector3 center_ = Vector3::Zero();
  double liftOfJoint_ = 4;
  double momentOfJoint_ = 0;
  bool isReversible_ = false;
  /// The plugin is one of Gazebo's releases after Fortress, in which wind, moments and the flow's direction count.
  bool isLater_ = false;
  const World* world_ = nullptr;

  std::optional<Link> link_;
  std::optional<CarriedLink> carried_;
  std::optional<Joint> joint_;
};

std::optional<Link> named(const Model& model, std::string_view name, Link*) { return model.link(name); }
std::optional<Joint> named(const Model& model, std::string_view name, Joint*) { return model.joint(name); }

/// Adds what has that name in the model or, as in Fortress, in any model nested in it.
template <class T>
void findAll(const Model& model, std::string_view name, std::vector<T>& found) {
  if (const auto part = named(model, name, static_cast<T*>(nullptr))) found.push_back(*part);
  for (const Model& inner : model.models()) findAll(inner, name, found);
}

/// @return The first part of that name in the order of the file; a warning reports further ones.
template <class T>
T partOf(const SystemContext& context, std::string_view parameter, const char* kind) {
  const Element& element = *context.sdf.child(parameter);
  const Model& model = *context.model;
  std::string_view name = element.text;
  std::vector<T> found;
  findAll(model, name, found);
  // the model's own name may precede it
  const std::string own = std::string(model.name()) + "::";
  if (found.empty() && name.starts_with(own)) findAll(model, name.substr(own.size()), found);
  const std::string subject = "<" + element.name + "> '" + element.text + "'";
  if (found.empty()) {
    refuse(element, subject + " is not a " + kind + " of model '" + std::string(model.name()) + "'",
           "of a nested model it is 'inner::" + std::string(name.substr(name.rfind(':') + 1)) + "'");
  }
  if (found.size() > 1) {
    context.diagnostics.warning(
        element.position, subject + " names " + std::to_string(found.size()) + " " + kind + "s: the first one is used");
  }
  return found.front();
}

void LiftDrag::configure(const SystemContext& context) {
  const Element& sdf = context.sdf;
  world_ = &context.world;
  isLater_ = sdf.attributeOr("filename", "").find("gz-sim") != std::string::npos;
  airfoil_.isReversible = isReversible_ || !isLater_;
  link_ = partOf<Link>(context, "link_name", "link");
  carried_.emplace(*link_);
  if (!jointName_.empty()) {
    joint_ = partOf<Joint>(context, "control_joint_name", "joint");
    if (joint_->axisCount() == 0) {
      refuse(*sdf.child("control_joint_name"), "<control_joint_name> '" + jointName_ + "' has no axis to turn about");
    }
  }
  const auto refuseVector = [&sdf](const char* name, const char* rule) {
    const Element* element = sdf.child(name);
    refuse(element != nullptr ? *element : sdf, std::string("<") + name + "> " + rule);
  };
  if (!(airfoil_.forward.norm() > 0)) refuseVector("forward", "must have a direction");
  if (!(airfoil_.upward.norm() > 0)) refuseVector("upward", "must have a direction");
  airfoil_.forward.normalize();
  airfoil_.upward.normalize();
  if (!airfoil_.isRound && airfoil_.forward.cross(airfoil_.upward).norm() < 1e-6) {
    refuseVector("upward", "is parallel to <forward>; it must have a component across it");
  }
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LiftDrag, "ignition::gazebo::systems::LiftDrag", "gz::sim::systems::LiftDrag");
