#pragma once

#include <LinearMath/btMatrix3x3.h>

#include <array>

#include "description/added_mass.hh"

namespace pongsim::physics {

/// The inertia of a body with fluid added mass: a matrix about the centre of mass, along the axes of Bullet's body
/// frame, linear before angular. A force may turn such a body, and its momentum need not lie along its velocity
/// (G. Kirchhoff, Vorlesungen ueber mathematische Physik, 1876, lecture 19). As in Gazebo, gravity pulls at the body's
/// own mass only.
class SpatialInertia {
 public:
  /// Linear, angular.
  using Motion = std::array<double, 6>;

  SpatialInertia(const description::AddedMass& ofLink, const Pose& X_LinkBody);

  /// @return Whether the body can have this mass [kg] and these principal moments of inertia [kg m^2].
  bool isPossibleWith(double mass, const Vector3& moments) const;
  /// Sets the body's own mass and principal moments of inertia, which must be possible.
  void setMass(double mass, const Vector3& moments);

  /// World frame [N, N m].
  struct Wrench {
    btVector3 force;
    btVector3 torque;
  };
  /// Turns the inertia to half a step ahead; like `gyration`, which see.
  /// @return The wrench with which the next step conserves momentum, if no other acts.
  Wrench advance(const btMatrix3x3& R_WorldBody, const btVector3& v, const btVector3& w, double dt, bool isHeld);

  using Matrix = description::AddedMass;
  /// @return The inertia half a step ahead, world frame.
  Matrix ahead() const;
  /// @return The change of velocity by an impulse half a step ahead, world frame.
  Motion respond(const btVector3& linear, const btVector3& angular) const;

 private:
  /// Body frame.
  Matrix ofFluid_;
  Matrix inertia_;
  Matrix inverse_;
  /// World frame.
  Matrix inverseAhead_;
};

}  // namespace pongsim::physics
