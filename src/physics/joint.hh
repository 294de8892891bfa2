#pragma once

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <optional>

#include "description/joint.hh"
#include "physics/body.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"
#include "world/state.hh"

namespace pongsim::physics {

/// One end of a joint: a body and the joint frame on it.
struct JointEnd {
  btRigidBody* body = nullptr;
  btTransform X_BodyJoint;
  bool moves = false;
};

/// A joint between two bodies, of any type, as rows for Bullet's solver: those that hold the bodies together, then one
/// of motor, friction and damping, then one of a limit that is near.
///
/// All rows meet in the child's joint origin. Directions are world frame; velocities are the child's relative to the
/// parent.
class Joint final : public btTypedConstraint {
 public:
  Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child);

  /// Whether it has an axis to command: revolute, continuous, prismatic.
  bool hasAxis() const { return turns_ || slides_; }
  void setVelocityTarget(double velocity);
  void addForce(double force) { force_ += force; }

  /// Puts forces on the bodies and decides which rows the coming step of `dt` [s] needs.
  void prepare(double dt);
  /// Takes position and velocity from the bodies.
  void update();

  /// What the joint did to its child at the joint's origin in the last step, world frame [N, N m]. Measured from the
  /// first call on.
  void readReaction(Vector3& force, Vector3& torque);

  const world::JointState& state() const { return state_; }

  /// All that it remembers from step to step.
  void transfer(StateArchive& archive);

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  /// The frames of both ends in the world frame.
  struct Frames {
    btTransform X_WorldParent;
    btTransform X_WorldChild;
    btVector3 axis;
  };
  struct Row;

  Frames frames() const;
  double angle(const Frames& frames) const;
  double reflectedInertia() const;
  void applyAxisForce(const Frames& frames, double force);
  void addLinearRows(Row& row, const Frames& frames, double errorRate) const;
  void addAngularRows(Row& row, const Frames& frames, double errorRate) const;
  void addAxisRows(Row& row, const Frames& frames, double fps, double erp) const;

  const description::JointAxis axis_;
  const bool turns_;
  const bool slides_;
  /// Rows that hold the bodies together.
  const int linearRows_;
  const int angularRows_;
  const btTransform X_ParentJoint_;
  const btTransform X_ChildJoint_;
  const bool parentMoves_;
  const bool childMoves_;
  /// [kg m^2] or [kg]: what a force along the axis has to move, were there no other joints.
  const double inertia_;

  std::optional<double> velocityTarget_;
  double force_ = 0;
  world::JointState state_;

  struct AxisRow {
    bool active = false;
    double velocity = 0;
    double lowestImpulse = 0;
    double highestImpulse = 0;
  };
  /// What the solver's rows did, once that has been asked for; with the force along the axis, which is none of them.
  btJointFeedback feedback_{};
  double appliedForce_ = 0;
  /// Where the rows met, seen from the child's centre of mass, and the axis; world frame.
  btVector3 childArm_{0, 0, 0};
  btVector3 stepAxis_{0, 0, 0};
  AxisRow motor_;
  AxisRow limit_;
};

}  // namespace pongsim::physics
