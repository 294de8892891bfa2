#include <ignition/msgs/vector3d.pb.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "marine_craft.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Names of forces, torques and velocities of the Society of Naval Architects and Marine Engineers.
constexpr std::string_view kForceLetters = "xyzkmn";
constexpr std::string_view kVelocityLetters = "UVWPQR";
/// Maximum velocity of a current [m/s].
constexpr double kFastestCurrent = 100;

/// Applies the drag and added mass of water to a link.
class Hydrodynamics : public System {
 public:
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override;

  void reset() override {
    current_ = defaultCurrent_;
    lastVelocity_.reset();
  }

  void transfer(StateArchive& archive) override {
    archive(current_);
    bool isMoving = lastVelocity_.has_value();
    archive(isMoving);
    if (archive.isGiving()) lastVelocity_ = isMoving ? std::optional(Vector6(Vector6::Zero())) : std::nullopt;
    if (!lastVelocity_) return;
    for (double& component : *lastVelocity_) archive(component);
  }

 private:
  void declareDerivatives(Declaration& declaration);
  void warnOfDerivatives(const SystemContext& context) const;
  Vector6 velocityThroughWater(const Quaternion& R_WorldLink) const;

  std::string linkName_;
  std::string namespace_;
  MarineCraft craft_;
  bool hasNoCoriolis_ = false;
  bool hasNoAddedMass_ = false;
  Vector3 defaultCurrent_ = Vector3::Zero();

  std::optional<Link> link_;
  /// Velocity of the water, world frame [m/s].
  Vector3 current_ = Vector3::Zero();
  /// Velocity in the last step, if there was one.
  std::optional<Vector6> lastVelocity_;

  Subscription currents_;
};

void Hydrodynamics::declare(Declaration& declaration) {
  declaration.is("Applies the drag and added mass of water to a link.", Declaration::Place::kModel);
  declaration.parameter("link_name", &linkName_, "", "link in the water").required();
  declareDerivatives(declaration);
  declaration.parameter("disable_coriolis", &hasNoCoriolis_, "", "disables Coriolis forces of the added mass");
  declaration.parameter("disable_added_mass", &hasNoAddedMass_, "", "disables inertial forces of the added mass");
  declaration.parameter("default_current", &defaultCurrent_, "m/s", "initial velocity of the water");
  declaration.parameter("namespace", &namespace_, "", "the topic of currents is `/model/NAMESPACE/ocean_current`");
  declaration.subscribes("/ocean_current", "ignition.msgs.Vector3d",
                         "velocity of the water in the world frame [m/s], which holds until the next one");
}

void Hydrodynamics::declareDerivatives(Declaration& declaration) {
  const auto add = [&](std::size_t i, std::size_t j, const std::string& name, Matrix6& matrix, const char* pattern,
                       const char* text) {
    double& entry = matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    declaration.parameter(name, &entry, "", text).inFamily(pattern);
  };
  const auto addPairs = [&](const std::string& middle, Matrix6& matrix, const char* pattern, const char* text) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j)
        add(i, j, kForceLetters[i] + middle + kVelocityLetters[j], matrix, pattern, text);
    }
  };
  const auto addTriples = [&](const std::string& middle, auto& matrices, const char* pattern, const char* text) {
    for (std::size_t i = 0; i < 36; ++i) {
      const std::string name = {kForceLetters[i / 6], kVelocityLetters[i % 6]};
      for (std::size_t k = 0; k < 6; ++k) {
        add(i / 6, i % 6, name + middle + kVelocityLetters[k], matrices[k], pattern, text);
      }
    }
  };
  addPairs("", craft_.linear, "{xyzkmn}{UVWPQR}", "linear drag: `xU`, `nR` [kg/s, kg m^2/s]; negative values brake");
  addTriples("abs", craft_.quadraticAbs, "{xyzkmn}{UVWPQR}abs{UVWPQR}",
             "quadratic drag: `xUabsU` [kg/m, kg m^2]; negative values brake");
  addTriples("", craft_.quadratic, "{xyzkmn}{UVWPQR}{UVWPQR}", "products of velocities: `xVR` [kg/m, kg m^2]");
  addPairs("Dot", craft_.addedMass, "{xyzkmn}Dot{UVWPQR}",
           "added mass: `xDotU`, `nDotR` [kg, kg m^2]; negative, and less than that of the model");
}

void Hydrodynamics::configure(const SystemContext& context) {
  link_ = requiredLink(context.sdf, "link_name", *context.model);
  if (defaultCurrent_.cwiseAbs().maxCoeff() > kFastestCurrent) {
    refuse(*context.sdf.child("default_current"), "<default_current> is too fast");
  }
  warnOfDerivatives(context);
  current_ = defaultCurrent_;
  const std::string topic = namespace_.empty() ? "/ocean_current" : "/model/" + namespace_ + "/ocean_current";
  currents_ = context.node.subscribe<ignition::msgs::Vector3d>(
      cleanTopic(topic),
      [this](const ignition::msgs::Vector3d& message) {
        current_ = {message.x(), message.y(), message.z()};
      },
      SubscriptionOptions{.largestNumber = kFastestCurrent});
}

/// Warns of parameters that look right but make a run unstable.
void Hydrodynamics::warnOfDerivatives(const SystemContext& context) const {
  double mass = 0;
  for (const Link& link : context.model->links()) mass += link.mass().mass;
  for (const Element& element : context.sdf.children) {
    const std::string& name = element.name;
    if (name.size() == 3 && name[1] == name[2] && kVelocityLetters.find(name[1]) == kForceLetters.find(name[0])) {
      context.diagnostics.warning(element.position, "<" + name + "> does not depend on the direction; for drag, use <" +
                                                        name.substr(0, 2) + "abs" + name[2] + ">");
    }
  }
  for (std::size_t i = 0; i < 3 && !hasNoAddedMass_; ++i) {
    const std::string name = std::string(1, kForceLetters[i]) + "Dot" + kVelocityLetters[i];
    const Element* element = context.sdf.child(name);
    const auto index = static_cast<Eigen::Index>(i);
    if (element == nullptr || std::abs(craft_.addedMass(index, index)) < mass) continue;
    context.diagnostics.warning(element->position,
                                "<" + name + "> is more than the mass of the model: its motion will be unstable");
  }
}

Vector6 Hydrodynamics::velocityThroughWater(const Quaternion& R_WorldLink) const {
  Vector6 velocity;
  velocity.head<3>() = R_WorldLink.conjugate() * (link_->linearVelocity() - current_);
  velocity.tail<3>() = R_WorldLink.conjugate() * link_->angularVelocity();
  return velocity;
}

void Hydrodynamics::preUpdate(const StepInfo& info) {
  if (info.paused) return;
  const Quaternion R_WorldLink = link_->pose().rotation;
  const Vector6 velocity = velocityThroughWater(R_WorldLink);
  const Vector6 acceleration = (velocity - lastVelocity_.value_or(velocity)) / toSeconds(info.dt);
  lastVelocity_ = velocity;

  Vector6 force = craft_.dampingForce(velocity);
  if (!hasNoAddedMass_) force += craft_.addedMassForce(acceleration);
  if (!hasNoCoriolis_) force += craft_.coriolisForce(velocity);
  // at speeds whose square overflows
  if (!force.allFinite()) return;
  link_->addWrench(R_WorldLink * Vector3(force.head<3>()), R_WorldLink * Vector3(force.tail<3>()));
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Hydrodynamics, "ignition::gazebo::systems::Hydrodynamics",
                      "gz::sim::systems::Hydrodynamics");
