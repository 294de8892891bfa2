#include "physics/body.hh"

#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "description/limits.hh"
#include "physics/convert.hh"
#include "physics/gyroscope.hh"
#include "physics/mass.hh"

namespace pongsim::physics {

namespace {

// a robot beyond these has exploded [m], [m/s, rad/s]
using description::kLargestPosition;
constexpr double kLargestVelocity = 1e9;

// speed that links are limited to [m/s]
constexpr double kMostSpeed = 1e6;

/// @return The vector with the length `most` where it is longer, and finite.
btVector3 shortened(const btVector3& vector, double most) {
  // the square of a finite number may be infinite
  const double length = fromBullet(vector).stableNorm();
  return length > most && std::isfinite(length) ? vector * (most / length) : vector;
}

/// @return Whether the rows are those of a rotation matrix, but for rounding.
bool isRotation(const btMatrix3x3& matrix) {
  constexpr double kRounding = 1e-6;
  const btMatrix3x3 product = matrix * matrix.transpose();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      if (!(std::abs(product[row][column] - (row == column ? 1 : 0)) < kRounding)) return false;
    }
  }
  return matrix.determinant() > 0;
}

PrincipalMass massOf(const world::Entities& entities, const world::LinkRecord& link) {
  if (!isMoving(link)) return {};
  try {
    return principalMass(link.description->inertial);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("link '" + entities.models()[link.model].scopedName + "::" + link.description->name +
                                "' can't move: " + error.what());
  }
}

btRigidBody::btRigidBodyConstructionInfo constructionInfo(const PrincipalMass& mass, btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(mass.mass, nullptr, shape, toBullet(mass.moments));
  info.m_linearDamping = 0;
  info.m_angularDamping = 0;
  return info;
}

}  // namespace

Body::Body(const world::Entities& entities, world::Slot link, const Vector3& gravity, HullStore& hulls,
           SharedShapes& shared)
    : Body(entities.links()[link], link, massOf(entities, entities.links()[link]), gravity, hulls, shared) {}

Body::Body(const world::LinkRecord& record, world::Slot link, const PrincipalMass& mass, const Vector3& gravity,
           HullStore& hulls, SharedShapes& shared)
    : link_(link),
      id_(record.id),
      moves_(isMoving(record)),
      hasGravity_(record.description->gravity),
      mass_{mass.mass},
      momentsOfFile_(toBullet(mass.moments)),
      moments_(momentsOfFile_),
      isRound_(mass.moments.x() == mass.moments.y() && mass.moments.y() == mass.moments.z()),
      X_LinkBody_(mass.X_LinkBody),
      X_BodyLink_(X_LinkBody_.inverse()),
      isCentred_(X_BodyLink_.position.isZero(0)),
      shape_(*record.description, X_BodyLink_, moves_, hulls, shared),
      rigid_(constructionInfo(mass, shape_.root())) {
  const description::Link& description = *record.description;
  setPose(record.X_WorldLinkStart);
  setLink(link);
  rigid_.setUserPointer(&shape_);
  int flags = rigid_.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK;
  if (!record.isStatic && description.kinematic) {
    flags = (flags & ~btCollisionObject::CF_STATIC_OBJECT) | btCollisionObject::CF_KINEMATIC_OBJECT;
  }
  rigid_.setCollisionFlags(flags);
  if (!moves_) return;

  if (const auto& added = description.inertial.addedMass) {
    rigid_.setSpatialInertia({*added, X_LinkBody_});
    rigid_.spatialInertia()->setMass(mass.mass, mass.moments);
  }
  // nothing sleeps
  rigid_.setActivationState(DISABLE_DEACTIVATION);
  rigid_.setDamping(description.linearDamping, description.angularDamping);
  rigid_.setFlags(BT_DISABLE_WORLD_GRAVITY);
  setGravity(gravity);
}

void Body::setLink(world::Slot link) {
  link_ = link;
  rigid_.setUserIndex(static_cast<int>(link));
}

bool Body::canHave(const Mass& mass) const {
  const SpatialInertia* inertia = rigid_.spatialInertia();
  return inertia == nullptr ||
         inertia->isPossibleWith(mass.mass, fromBullet(momentsOfFile_).cwiseProduct(mass.stretch) * mass.inertiaFactor);
}

void Body::setMass(const Mass& mass) {
  mass_ = mass;
  const btVector3 factors = toBullet(Vector3(mass.stretch * mass.inertiaFactor));
  // a product with 1 has the same bits
  moments_ = momentsOfFile_ * factors;
  isRound_ = moments_.x() == moments_.y() && moments_.y() == moments_.z();
  assert(moves_ && mass.mass > 0 && mass.inertiaFactor > 0 && mass.stretch.minCoeff() > 0);
  rigid_.setMassProps(mass.mass, moments_);
  // Bullet keeps the weight
  rigid_.setGravity(rigid_.getGravity());
  rigid_.updateInertiaTensor();
  if (rigid_.spatialInertia() != nullptr) rigid_.spatialInertia()->setMass(mass.mass, fromBullet(moments_));
}

void Body::reshape(const description::Link& description, HullStore& hulls, SharedShapes& shared) {
  shape_.reshape(description, X_BodyLink_, moves_, hulls, shared);
  rigid_.setCollisionShape(shape_.root());
}

void Body::setGravity(const Vector3& gravity) {
  if (moves_ && hasGravity_) rigid_.setGravity(toBullet(gravity));
}

void Body::setPose(const Pose& X_WorldLink) {
  assert(std::abs(X_WorldLink.rotation.squaredNorm() - 1) < 1e-3);
  rigid_.setWorldTransform(toBullet(X_WorldLink * X_LinkBody_));
  rigid_.setInterpolationWorldTransform(rigid_.getWorldTransform());
  rigid_.updateInertiaTensor();
}

void Body::addForces(double dt, bool isHeld) {
  rigid_.applyGravity();
  btMatrix3x3& basis = rigid_.getWorldTransform().getBasis();
  if (SpatialInertia* const inertia = rigid_.spatialInertia()) {
    const auto [force, torque] =
        inertia->advance(basis, rigid_.getLinearVelocity(), rigid_.getAngularVelocity(), dt, isHeld);
    rigid_.applyCentralForce(force);
    rigid_.applyTorque(torque);
    return;
  }
  std::optional<Gyration> gyroscopic;
  if (!isRound_) gyroscopic = gyration(basis, rigid_.getAngularVelocity(), moments_, dt, isHeld);
  if (!gyroscopic) {
    rigid_.updateInertiaTensor();
    return;
  }
  rigid_.applyTorque(gyroscopic->torque);
  // Bullet computes the inertia for the current orientation, so that is replaced for a moment
  const btMatrix3x3 now = std::exchange(basis, gyroscopic->R_WorldAhead);
  rigid_.updateInertiaTensor();
  basis = now;
}

void Body::addWrench(const Vector3& force, const Vector3& torque) {
  if (!moves_) return;
  if (isCentred_) {
    rigid_.applyCentralForce(toBullet(force));
  } else {
    const btVector3 comToLink = rigid_.getWorldTransform().getBasis() * toBullet(X_BodyLink_.position);
    rigid_.applyForce(toBullet(force), comToLink);
  }
  rigid_.applyTorque(toBullet(torque));
}

void Body::setVelocity(const Vector3& linear, const Vector3& angular) {
  const Vector3 linkToCom = -fromBullet(rigid_.getWorldTransform().getBasis() * toBullet(X_BodyLink_.position));
  rigid_.setLinearVelocity(toBullet(linear + angular.cross(linkToCom)));
  rigid_.setAngularVelocity(toBullet(angular));
}

void Body::transfer(StateArchive& archive) {
  // the matrix itself: a quaternion made of it is another by a bit
  btTransform transform = rigid_.getWorldTransform();
  transferVector(archive, transform.getOrigin());
  for (int row = 0; row < 3; ++row) transferVector(archive, transform.getBasis()[row]);
  btVector3 linear = rigid_.getLinearVelocity();
  btVector3 angular = rigid_.getAngularVelocity();
  btVector3 force = rigid_.getTotalForce();
  btVector3 torque = rigid_.getTotalTorque();
  for (btVector3* vector : {&linear, &angular, &force, &torque}) transferVector(archive, *vector);
  archive.check(isWithin(transform.getOrigin(), description::kFarthestSaved) && isRotation(transform.getBasis()) &&
                isWithin(linear, description::kFastestSaved) && isWithin(angular, description::kFastestSaved) &&
                isWithin(force, description::kStrongestSaved) && isWithin(torque, description::kStrongestSaved));
  shape_.transfer(archive, rigid_);
  Mass mass = mass_;
  if (moves_) {
    archive(mass.mass);
    archive(mass.inertiaFactor);
    archive(mass.stretch);
    const auto isFactor = [](double factor) {
      return factor >= description::kLeastMass && factor <= description::kLargestMass;
    };
    archive.check(isFactor(mass.mass) && isFactor(mass.inertiaFactor) && isFactor(mass.stretch.minCoeff()) &&
                  isFactor(mass.stretch.maxCoeff()));
    archive.check(canHave(mass));
  }
  if (!archive.isGiving()) return;
  if (mass != mass_) setMass(mass);
  rigid_.setWorldTransform(transform);
  rigid_.setInterpolationWorldTransform(transform);
  rigid_.updateInertiaTensor();
  rigid_.setLinearVelocity(linear);
  rigid_.setAngularVelocity(angular);
  rigid_.clearForces();
  rigid_.applyCentralForce(force);
  rigid_.applyTorque(torque);
}

bool Body::slowDown(double dt) {
  constexpr double kMostTurn = 2 * std::numbers::pi;
  const btVector3 linear = rigid_.getLinearVelocity(), angular = rigid_.getAngularVelocity();
  if (linear.length2() <= kMostSpeed * kMostSpeed && angular.length2() * dt * dt <= kMostTurn * kMostTurn) return false;
  rigid_.setLinearVelocity(shortened(linear, kMostSpeed));
  rigid_.setAngularVelocity(shortened(angular, kMostTurn / dt));
  return rigid_.getLinearVelocity() != linear || rigid_.getAngularVelocity() != angular;
}

bool Body::read(world::LinkState& state) const {
  state.X_WorldLink = fromBullet(rigid_.getWorldTransform()) * X_BodyLink_;
  state.w_WorldLink = fromBullet(rigid_.getAngularVelocity());

  // velocity of the link's origin, which turns about the centre of mass
  const Vector3 comToLink = state.X_WorldLink.position - fromBullet(rigid_.getWorldTransform().getOrigin());
  state.v_WorldLink = fromBullet(rigid_.getLinearVelocity()) + state.w_WorldLink.cross(comToLink);

  // false, too, where a value is not a number
  return state.X_WorldLink.position.squaredNorm() < kLargestPosition * kLargestPosition &&
         state.X_WorldLink.rotation.squaredNorm() < 2 &&
         state.v_WorldLink.squaredNorm() + state.w_WorldLink.squaredNorm() < kLargestVelocity * kLargestVelocity;
}

}  // namespace pongsim::physics
