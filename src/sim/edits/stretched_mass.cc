#include "sim/edits/stretched_mass.hh"

#include <cmath>
#include <string>

#include "description/limits.hh"
#include "sdf/readers/models/mass_properties.hh"

namespace pongsim::sim {

namespace {

/// Half the trace minus the tensor turns moments of inertia into the integrals of x x^T, and the trace minus the tensor
/// turns these back.
Matrix3 secondMoments(const Matrix3& inertia) { return inertia.trace() / 2 * Matrix3::Identity() - inertia; }
Matrix3 inertiaOf(const Matrix3& second) { return second.trace() * Matrix3::Identity() - second; }

/// @return By how much a shape is stretched along its axes: the ratio of the spread of its volume, which is exact for
/// a box, cylinder or ellipsoid.
Vector3 stretchOf(const sdf::MassProperties& before, const sdf::MassProperties& after) {
  const Vector3 spreadBefore = secondMoments(before.moments).diagonal() / before.mass;
  const Vector3 spreadAfter = secondMoments(after.moments).diagonal() / after.mass;
  return (spreadAfter.array() / spreadBefore.array()).sqrt();
}

bool isFactor(double number) { return number >= description::kLeastMass && number <= description::kLargestMass; }

}  // namespace

Outcome<physics::Engine::Mass> stretchedMass(const Access& access, world::Slot link,
                                             const description::Geometry& before, const description::Collision& after) {
  const world::LinkRecord& record = access.entities.links()[link];
  const std::string wrong = "the mass of link '" + access.entities.models()[record.model].scopedName +
                            "::" + record.description->name + "' can't follow the size of a collision: ";
  const physics::Engine::Mass now = access.engine.mass(link);
  if (now.mass == 0) return {std::nullopt, wrong + "the link does not move"};
  if (record.description->collisions.size() != 1) return {std::nullopt, wrong + "the link has several; set its mass"};
  const Pose& X_LinkCom = record.description->inertial.X_LinkCom;
  const sdf::MassProperties old = sdf::massPropertiesOf(before, 1).value();
  const sdf::MassProperties wanted = sdf::massPropertiesOf(after.geometry, 1).value();
  const Vector3 stretch = stretchOf(old, wanted);
  const double volume = wanted.mass / old.mass;

  constexpr double kRounding = 1e-6;
  const double extent = std::sqrt(secondMoments(old.moments).trace() / old.mass);
  if ((X_LinkCom.position - after.X_LinkCollision.position).norm() > kRounding * extent) {
    return {std::nullopt, wrong + "its centre of mass is not that of the collision; set its mass"};
  }
  const physics::Engine::Inertia file = access.engine.inertiaOfFile(link);
  const Vector3 moments = now.inertiaFactor * file.moments.cwiseProduct(now.stretch);
  const Matrix3 R_AxesShape = (file.q_LinkAxes.conjugate() * after.X_LinkCollision.rotation).toRotationMatrix();
  const Matrix3 map = R_AxesShape * stretch.asDiagonal() * R_AxesShape.transpose();
  const Matrix3 inertia = inertiaOf(volume * map * secondMoments(moments.asDiagonal()) * map);
  const Vector3 along = inertia.diagonal();
  if (Matrix3(inertia - Matrix3(along.asDiagonal())).norm() > kRounding * inertia.norm()) {
    return {std::nullopt, wrong + "its principal axes of inertia would turn; set its mass"};
  }
  const double factor = now.inertiaFactor * volume;
  physics::Engine::Mass mass{now.mass * volume, factor, (along.array() / file.moments.array() / factor).matrix()};
  const bool isInRange =
      isFactor(mass.mass) && isFactor(factor) && isFactor(mass.stretch.minCoeff()) && isFactor(mass.stretch.maxCoeff());
  if (!isInRange) return {std::nullopt, wrong + "it would be beyond what is possible"};
  if (!access.engine.canHave(link, mass)) {
    return {std::nullopt, wrong + "with its fluid_added_mass, it would have no positive definite inertia"};
  }
  return {mass, {}};
}

}  // namespace pongsim::sim
