#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <optional>

#include "physics/spatial_inertia.hh"

namespace pongsim::physics {

/// A rigid body that may have fluid added mass.
class RigidBody : public btRigidBody {
 public:
  explicit RigidBody(const btRigidBodyConstructionInfo& info) : btRigidBody(info) {}

  void setSpatialInertia(const SpatialInertia& inertia) {
    spatialInertia_ = inertia;
    setUserIndex3(kHasSpatialInertia);
  }
  /// @return Null for a body with mass and moments only.
  SpatialInertia* spatialInertia() { return spatialInertia_ ? &*spatialInertia_ : nullptr; }
  const SpatialInertia* spatialInertia() const { return spatialInertia_ ? &*spatialInertia_ : nullptr; }

  /// Third index of bodies that have one. Other bodies may be Bullet's own.
  static constexpr int kHasSpatialInertia = 1;

 private:
  std::optional<SpatialInertia> spatialInertia_;
};

inline const SpatialInertia* spatialInertiaOf(const btRigidBody& body) {
  if (body.getUserIndex3() != RigidBody::kHasSpatialInertia) return nullptr;
  return static_cast<const RigidBody&>(body).spatialInertia();
}

}  // namespace pongsim::physics
