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

/// A joint between two bodies as rows for Bullet's solver: those that hold the bodies together, then for each axis one
/// for motor, friction and damping, and one for a limit that is near.
///
/// All rows act at the child's joint origin. Directions are in the world frame; velocities are the child's relative to
/// the parent. The first axis is fixed to the parent, a second one to the child: the child turns about the second axis
/// in a frame that turns about the first.
///
/// A gearbox couples the rotations of its ends about two axes of a third body with one row, and has no axis to command.
class Joint final : public btTypedConstraint {
 public:
  /// @param reference For a gearbox: the body that its axes are fixed to.
  Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child,
        const JointEnd& reference = {});

  /// Slot of the joint in the world.
  world::Slot slot() const { return slot_; }
  void setSlot(world::Slot slot) { slot_ = slot; }

  /// @return Whether at least one of its ends moves.
  bool holdsSomething() const { return parentMoves_ || childMoves_; }

  /// @return For a gearbox, the row that must follow it in the solver's list; null if there is none.
  btTypedConstraint* reference() { return gearbox_ && gearbox_->part ? &*gearbox_->part : nullptr; }

  /// Number of axes that can be commanded.
  std::size_t axisCount() const { return axisCount_; }
  /// Prefetches what a command of the first axis needs.
  void prefetchAxis() const {
    base::prefetch(axisCount_);
    base::prefetch(axes_.front());
  }
  void setVelocityTarget(double velocity, std::size_t axis);
  void clearVelocityTarget(std::size_t axis) { axes_[axis].velocityTarget.reset(); }
  void setPosition(double position, std::size_t axis) { axes_[axis].position = position; }
  void addForce(double force, std::size_t axis) { axes_[axis].force += force; }
  /// @return Whether any axis has a nonzero commanded force or velocity.
  bool isDriven() const;
  /// Clears the commands of the axes.
  void release();

  /// Applies forces to the bodies and decides which rows the next step of `dt` [s] needs.
  void prepare(double dt);
  /// Reads position and velocity from the bodies.
  void update();

  /// Reads the wrench that the joint exerted on its child at the joint's origin in the last step, world frame [N, N m].
  /// Measured from the first call on.
  void readReaction(Vector3& force, Vector3& torque);

  world::JointState state() const;

  /// Saves or restores everything that it keeps from step to step.
  void transfer(StateArchive& archive);

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  struct Axes {
    /// The axes themselves, world frame.
    std::array<btVector3, 2> axes;
    /// A torque along one of these does work on its own axis only; a relative rotation along it is that axis' velocity.
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
    /// [kg m^2] or [kg]: the inertia that a force along the axis moves, ignoring other joints.
    double inertia = 0;
    std::optional<double> velocityTarget;
    double force = 0;
    double position = 0;
    double velocity = 0;
    /// The force applied to the bodies in the last step outside the rows, and its direction.
    double appliedForce = 0;
    btVector3 appliedAlong{0, 0, 0};
    AxisRow motor;
    AxisRow limit;

    void follow(double angle);
  };
  struct Row;
  /// @return Zeros; Bullet's vectors are not initialized.
  static btJointFeedback noFeedback() { return {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; }
  struct Gearbox {
    double ratio;
    btRigidBody& body;
    /// Rotated so that x is the first axis.
    btTransform X_BodyJoint;
    /// Present if the body moves.
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
  /// Translation of a screw's child along the axis [m/rad].
  const double lead_;
  /// Rows that hold the bodies together.
  const int linearRows_;
  const int angularRows_;
  /// Rotated so that x is the first axis.
  const btTransform X_ParentJoint_;
  const btTransform X_ChildJoint_;
  /// The second axis in both frames, at the start.
  const btVector3 secondAxis_;
  const bool parentMoves_;
  const bool childMoves_;
  std::array<Axis, 2> axes_;
  std::unique_ptr<Gearbox> gearbox_;

  /// The impulses of the solver's rows, once asked for.
  btJointFeedback feedback_ = noFeedback();
  /// The point where the rows act, relative to the child's centre of mass; world frame.
  btVector3 childArm_{0, 0, 0};
};

}  // namespace pongsim::physics
