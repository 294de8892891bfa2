#pragma once

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "base/prefetch.hh"
#include "description/joint.hh"
#include "physics/body.hh"
#include "physics/gearbox.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "world/state.hh"

namespace pongsim::physics {

/// One end of a joint: a body and the joint frame on it.
struct JointEnd {
  btRigidBody* body = nullptr;
  btTransform X_BodyJoint;
  bool moves = false;
};

/// A joint between two bodies as rows for Bullet's solver: those that hold the bodies
/// together, then of each axis one of motor, friction and damping, and one of a limit that is near.
///
/// All rows meet in the child's joint origin. Directions are world frame; velocities are the child's relative to the
/// parent. The first axis is fixed to the parent, a second one to the child: the child turns about the second axis in a
/// frame that turns about the first.
///
/// A gearbox holds the turns of its ends about two axes of a third body together by one row, and has no axis to
/// command.
class Joint final : public btTypedConstraint {
 public:
  /// @param reference Of a gearbox: what its axes are fixed to.
  Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child,
        const JointEnd& reference = {});

  /// Of the joint in the world.
  world::Slot slot() const { return slot_; }
  void setSlot(world::Slot slot) { slot_ = slot; }

  /// @return Whether one of its ends moves.
  bool holdsSomething() const { return parentMoves_ || childMoves_; }

  /// @return Of a gearbox, what must follow it in the solver's list; null where there is no such thing.
  btTypedConstraint* reference() { return gearbox_ && gearbox_->part ? &*gearbox_->part : nullptr; }

  /// How many axes it has to command.
  std::size_t axisCount() const { return axisCount_; }
  /// Asks for the memory of what a command of the first axis needs.
  void prefetchAxis() const {
    base::prefetch(axisCount_);
    base::prefetch(axes_.front());
  }
  void setVelocityTarget(double velocity, std::size_t axis);
  void clearVelocityTarget(std::size_t axis) { axes_[axis].velocityTarget.reset(); }
  void setPosition(double position, std::size_t axis) { axes_[axis].position = position; }
  void addForce(double force, std::size_t axis) { axes_[axis].force += force; }
  /// @return Whether a force or a velocity other than zero is asked of an axis.
  bool isDriven() const;
  /// Takes back what is asked of the axes.
  void release();

  /// Puts forces on the bodies and decides which rows the coming step of `dt` [s] needs.
  void prepare(double dt);
  /// Takes position and velocity from the bodies.
  void update();

  /// What the joint did to its child at the joint's origin in the last step, world frame [N, N m]. Measured from the
  /// first call on.
  void readReaction(Vector3& force, Vector3& torque);

  world::JointState state() const;

  /// All that it remembers from step to step.
  void transfer(StateArchive& archive);

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  struct Axes {
    /// The axes themselves, world frame.
    std::array<btVector3, 2> axes;
    /// A torque along one of these does work on its axis alone, and a relative turn along it is that axis' velocity.
    std::array<btVector3, 2> drives;
  };
  /// The frames of both ends in the world frame.
  struct Frames : Axes {
    btTransform X_WorldParent;
    btTransform X_WorldChild;
  };
  struct AxisRow {
    bool active = false;
    double velocity = 0;
    double lowestImpulse = 0;
    double highestImpulse = 0;
  };
  struct Axis {
    description::JointAxis description;
    /// [kg m^2] or [kg]: what a force along the axis has to move, were there no other joints.
    double inertia = 0;
    std::optional<double> velocityTarget;
    double force = 0;
    double position = 0;
    double velocity = 0;
    /// The force that was put on the bodies in the last step, which no row has, and along what.
    double appliedForce = 0;
    btVector3 appliedAlong{0, 0, 0};
    AxisRow motor;
    AxisRow limit;

    void follow(double angle);
  };
  struct Row;
  /// @return Zeros; Bullet's vectors are not by themselves.
  static btJointFeedback noFeedback() { return {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; }
  struct Gearbox {
    double ratio;
    btRigidBody& body;
    /// Turned so that x is the first axis.
    btTransform X_BodyJoint;
    /// Where the body moves.
    std::optional<GearReference> part;
  };

  double inertiaOf(const JointEnd& parent, const JointEnd& child, const btVector3& axis) const;
  Axes axesAlong(const btVector3& first) const;
  Frames frames() const;
  std::array<double, 2> angles(const Frames& frames) const;
  double offset(const Frames& frames) const;
  void prepare(Axis& axis, const btVector3& along, double dt);
  void updateTurn();
  void updateGears();
  void addGearRow(Row& row, double errorRate);
  void applyForce(const btVector3& force, const btVector3& point);
  void addLinearRows(Row& row, const Frames& frames, double errorRate, const btVector3& bent) const;
  void addAngularRows(Row& row, const Frames& frames, double errorRate) const;
  void addCrossRow(Row& row, const Frames& frames, double errorRate) const;
  void addAxisRows(Row& row, const Axis& axis, const btVector3& along, double fps, double erp) const;

  world::Slot slot_ = world::kNoSlot;
  const description::JointType type_;
  const std::size_t axisCount_;
  const bool slides_;
  /// How far a screw's child moves along the axis [m/rad].
  const double lead_;
  /// Rows that hold the bodies together.
  const int linearRows_;
  const int angularRows_;
  /// Turned so that x is the first axis.
  const btTransform X_ParentJoint_;
  const btTransform X_ChildJoint_;
  /// The second axis in both, at the start.
  const btVector3 secondAxis_;
  const bool parentMoves_;
  const bool childMoves_;
  std::array<Axis, 2> axes_;
  std::unique_ptr<Gearbox> gearbox_;

  /// What the solver's rows did, once that has been asked for.
  btJointFeedback feedback_ = noFeedback();
  /// Where the rows met, seen from the child's centre of mass; world frame.
  btVector3 childArm_{0, 0, 0};
};

}  // namespace pongsim::physics
