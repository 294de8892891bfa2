#include "rotors.hh"

#include <cmath>
#include <cstddef>
#include <string>

#include <Eigen/LU>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

/// A pivot below this fraction of the largest one counts as zero.
constexpr double kSmallestPivot = 1e-9;

double positiveIn(const Element& rotor, std::string_view name, bool mayBeZero) {
  requiredText(rotor, name);
  const double value = rotor.child(name)->as<double>();
  if (!std::isfinite(value) || value < 0 || (value == 0 && !mayBeZero)) {
    refuse(*rotor.child(name),
           "<" + std::string(name) + "> must be a number " + (mayBeZero ? "of at least" : "above") + " zero");
  }
  return value;
}

Rotor readRotor(const Element& element, const Model& model, const Link& body) {
  const Joint joint = requiredJoint(element, "jointName", model);
  const Pose X_BodyModel = body.poseInModel().inverse();
  const Pose X_BodyJoint = X_BodyModel * joint.child().poseInModel() * joint.poseInChild();
  Rotor rotor;
  rotor.x = X_BodyJoint.position.x();
  rotor.y = X_BodyJoint.position.y();
  // only the vertical part of a tilted rotor's thrust counts
  rotor.forceConstant = positiveIn(element, "forceConstant", false) * (X_BodyJoint.rotation * joint.axisInfo().xyz).z();
  rotor.momentConstant = positiveIn(element, "momentConstant", true);
  requiredText(element, "direction");
  rotor.direction = element.child("direction")->as<int>();
  if (rotor.direction != 1 && rotor.direction != -1) {
    refuse(*element.child("direction"), "<direction> is " + std::to_string(rotor.direction),
           "it can be 1 (anticlockwise) or -1 (clockwise), seen from above");
  }
  return rotor;
}

}  // namespace

std::vector<Rotor> readRotors(const Element& configuration, const Model& model, const Link& body) {
  std::vector<Rotor> rotors;
  for (const Element* element : configuration.childrenNamed("rotor")) {
    rotors.push_back(readRotor(*element, model, body));
  }
  return rotors;
}

Allocation allocationOf(const std::vector<Rotor>& rotors) {
  Allocation allocation(4, static_cast<Eigen::Index>(rotors.size()));
  for (std::size_t i = 0; i < rotors.size(); ++i) {
    const Rotor& rotor = rotors[i];
    allocation.col(static_cast<Eigen::Index>(i)) << rotor.y * rotor.forceConstant, -rotor.x * rotor.forceConstant,
        -rotor.direction * rotor.forceConstant * rotor.momentConstant, rotor.forceConstant;
  }
  return allocation;
}

int rankOf(const Allocation& allocation) {
  if (allocation.cols() == 0) return 0;
  Eigen::FullPivLU<Allocation> decomposition(allocation);
  decomposition.setThreshold(kSmallestPivot);
  return static_cast<int>(decomposition.rank());
}

}  // namespace pongsim
