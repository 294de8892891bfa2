#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "description/joint.hh"
#include "physics/body.hh"
#include "physics/joint_motion.hh"
#include "physics/joint_row.hh"
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

/// A joint between two bodies as constraint rows: those that hold the bodies together, then for each axis one for
/// motor, friction and damping, and one for each limit that is near.
///
/// All rows act at the child's joint origin. Directions are in the world frame; velocities are the child's relative to
/// the parent. The first axis is fixed to the parent, a second one to the child: the child turns about the second axis
/// in a frame that turns about the first.
///
/// A gearbox couples the rotations of its ends about two axes of a third body with one row, and has no axis to command.
class Joint final {
 public:
  /// Maximum number of rows: those of a universal joint with two motors, dampers and two limits of each axis.
  static constexpr std::size_t kMostRows = 12;
  /// Maximum number of those without bounds: those of a universal joint with two dampers and both axes locked.
  static constexpr std::size_t kMostEquations = 8;

  /// @param reference For a gearbox: the body that its axes are fixed to.
  Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child,
        const JointEnd& reference = {});

  /// Slot of the joint in the world.
  world::Slot slot() const { return slot_; }
  void setSlot(world::Slot slot) { slot_ = slot; }

  /// @return Whether at least one of its ends moves.
  bool holdsSomething() const { return parentMoves_ || childMoves_; }

  btRigidBody& parent() const { return parent_; }
  btRigidBody& child() const { return child_; }
  /// @return For a gearbox, the body that its axes are fixed to, if that moves; else null.
  btRigidBody* reference() const { return gearbox_ && gearbox_->moves ? &gearbox_->body : nullptr; }

  bool isGearbox() const { return gearbox_ != nullptr; }

  /// Number of axes that can be commanded.
  std::size_t axisCount() const { return axisCount_; }
  void setVelocityTarget(double velocity, std::size_t axis);
  void clearVelocityTarget(std::size_t axis) { axes_[axis].velocityTarget.reset(); }
  void setPosition(double position, std::size_t axis) { axes_[axis].position = position; }
  /// Makes an axis follow another joint's, as its `<mimic>` says, wherever it has no velocity target.
  /// @param leader Must outlive this, like `mimic`.
  void follow(std::size_t axis, const Joint& leader, const description::Mimic& mimic) {
    axes_[axis].leader = &leader;
    axes_[axis].mimic = &mimic;
  }
  void addForce(double force, std::size_t axis) { axes_[axis].force += force; }
  /// What resists the motion of an axis: damping [N m s/rad or N s/m] and friction [N m or N].
  struct Resistance {
    double damping = 0;
    double friction = 0;
  };
  Resistance resistance(std::size_t axis) const { return {axes_[axis].limits.damping, axes_[axis].limits.friction}; }
  void setResistance(const Resistance& resistance, std::size_t axis) {
    axes_[axis].limits.damping = resistance.damping;
    axes_[axis].limits.friction = resistance.friction;
    axes_[axis].areLimitsChanged = true;
  }
  /// How far and how strongly an axis moves: positions [rad or m], locked if both are the same, and the effort of its
  /// motor and its commands [N m or N]. May be infinite.
  struct Bounds {
    double lower = 0;
    double upper = 0;
    double effort = 0;
  };
  Bounds bounds(std::size_t axis) const {
    return {axes_[axis].limits.lower, axes_[axis].limits.upper, axes_[axis].limits.effort};
  }
  void setBounds(const Bounds& bounds, std::size_t axis) {
    axes_[axis].limits.lower = bounds.lower;
    axes_[axis].limits.upper = bounds.upper;
    axes_[axis].limits.effort = bounds.effort;
    axes_[axis].areLimitsChanged = true;
  }
  /// @return Whether any axis has a nonzero commanded force or velocity.
  bool isDriven() const;
  /// Clears the commands of the axes.
  void release();

  /// Applies forces to the bodies and decides which rows the next step of `dt` [s] needs.
  void prepare(double dt);
  /// Reads position and velocity from the bodies.
  void update();

  /// Reads the wrench that the joint exerted on its child at the joint's origin in the last step, world frame [N, N m].
  /// Measured from the first call on, zero until the next step.
  void readReaction(Vector3& force, Vector3& torque);

  world::JointState state() const;

  /// Saves or restores everything that it keeps from step to step.
  void transfer(StateArchive& archive);

  /// @return The number of rows of the coming step, once that is prepared.
  std::size_t rowCount() const;
  /// Writes the rows of the coming step of `dt` [s] to the front of `rows`.
  /// @param erp Fraction of a position error that is corrected in the step (error reduction parameter).
  /// @return The rows that were written.
  std::span<const JointRow> rows(double dt, double erp, std::span<JointRow, kMostRows> rows);

  /// Writes how the joint moves in the coming step instead, and to the front of `rows` only those with bounds. Not for
  /// gearboxes.
  std::span<const JointRow> motion(double dt, double erp, JointMotion& motion, std::span<JointRow, kMostRows> rows);

  bool isMeasured() const { return isMeasured_; }
  /// Takes what the rows exerted on the child's centre of mass in the last step, world frame [N, N m].
  void setReaction(const btVector3& force, const btVector3& torque);

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
  /// A row without bounds.
  struct Damper {
    bool active = false;
    double velocity = 0;
    double compliance = 0;
  };
  /// The limits of an axis that a step could reach; locked if both are the same.
  enum class Stops { kNone, kLower, kUpper, kBoth, kLocked };
  /// What a step needs of a `description::JointAxis`.
  struct Limits {
    explicit Limits(const description::JointAxis& axis = {});

    double lower, upper, effort, velocity, damping, friction, springReference, springStiffness;
  };
  struct Axis {
    Limits limits;
    /// Those of the description, and whether others are in their place.
    Limits ofFile;
    bool areLimitsChanged = false;
    std::optional<double> velocityTarget;
    /// Where the axis follows another one.
    const Joint* leader = nullptr;
    const description::Mimic* mimic = nullptr;
    double force = 0;
    double position = 0;
    double velocity = 0;
    /// The force applied to the bodies in the last step outside the rows, and its direction.
    double appliedForce = 0;
    btVector3 appliedAlong{0, 0, 0};
    AxisRow motor;
    Damper damper;
    Stops stops = Stops::kNone;

    void unwrap(double angle);
  };
  struct RowWriter;
  struct Gearbox {
    double ratio;
    /// The reference body.
    btRigidBody& body;
    bool moves;
    /// Rotated so that x is the first axis.
    btTransform X_BodyJoint;
  };

  Axes axesAlong(const btVector3& first) const;
  Frames frames() const;
  std::array<double, 2> angles(const Frames& frames) const;
  double offset(const Frames& frames) const;
  void prepare(Axis& axis, const btVector3& along, double dt);
  static std::optional<double> targetOf(const Axis& axis, double dt);
  static void prepareDamper(Axis& axis, double dt);
  static Stops stopsOf(const Axis& axis, double dt);
  void updateTurn();
  void updateGears();
  btMatrix3x3 gearboxBasis() const;
  void applyForce(const btVector3& force, const btVector3& point);
  void addGearRow(RowWriter& writer, double errorRate) const;
  void addLinearRows(RowWriter& writer, const Frames& frames, double errorRate, const btVector3& chordVelocity) const;
  void addAngularRows(RowWriter& writer, const Frames& frames, double errorRate) const;
  void addCrossRow(RowWriter& writer, const Frames& frames, double errorRate) const;
  void addAxisRows(RowWriter& writer, const Axis& axis, const btVector3& along, double rate, double erp,
                   bool withEquations) const;
  void addFreedom(JointMotion& motion, const Axis& axis, const btVector3& along, double errorRate) const;
  btVector3 heldVelocity(const Frames& frames, double errorRate, const btVector3& chordVelocity) const;
  btVector3 heldTurn(const Frames& frames, double errorRate) const;
  btVector3 angularError(const Frames& frames) const;
  std::pair<btVector3, double> crossError(const Frames& frames) const;

  btRigidBody& parent_;
  btRigidBody& child_;
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

  /// Whether the reaction is read.
  bool isMeasured_ = false;
  /// What the rows exerted on the child's centre of mass.
  btVector3 force_{0, 0, 0};
  btVector3 torque_{0, 0, 0};
  /// The point where the rows act, relative to the child's centre of mass; world frame.
  btVector3 childArm_{0, 0, 0};
};

}  // namespace pongsim::physics
