#include "physics/joint.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/convert.hh"

namespace pongsim::physics {

namespace {

using description::JointType;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bullet's own infinity; it does not expect that of IEEE
double impulseLimit(double impulse) { return std::min(impulse, static_cast<double>(SIMD_INFINITY)); }

description::JointAxis axisOf(const description::Joint& joint) {
  return joint.axes.empty() ? description::JointAxis() : joint.axes.front();
}

bool turnsAboutAxis(JointType type) { return type == JointType::kRevolute || type == JointType::kContinuous; }

int heldDirections(JointType type) { return type == JointType::kPrismatic ? 2 : 3; }

int heldTurns(JointType type) {
  if (type == JointType::kBall) return 0;
  return turnsAboutAxis(type) ? 2 : 3;
}

// the joint frame turned so that its x axis is the joint's axis: the other two are then the held directions
btTransform alongAxis(const btTransform& X_BodyJoint, const Vector3& axis) {
  const Quaternion turn = Quaternion::FromTwoVectors(Vector3::UnitX(), axis);
  return X_BodyJoint * btTransform(toBullet(turn));
}

// moment of inertia of the body about an axis through a point of it, both in its frame; infinite if it can't move
double inertiaAbout(const JointEnd& end, const btTransform& X_BodyAxis) {
  if (!end.moves) return kInfinity;
  const btVector3 axis = X_BodyAxis.getBasis().getColumn(0);
  const btVector3 inverse = end.body->getInvInertiaDiagLocal();
  const btVector3 own(axis.x() * axis.x() / inverse.x(), axis.y() * axis.y() / inverse.y(),
                      axis.z() * axis.z() / inverse.z());
  return own.x() + own.y() + own.z() + X_BodyAxis.getOrigin().cross(axis).length2() / end.body->getInvMass();
}

double inertiaAlong(const JointEnd& end) { return end.moves ? 1 / end.body->getInvMass() : kInfinity; }

}  // namespace

/// Fills the solver's rows one after the other.
struct Joint::Row {
  btConstraintInfo2* info;
  btVector3 parentArm;
  btVector3 childArm;
  int index = 0;

  // the child's velocity along `direction` at the joint, seen from the parent, shall become `velocity`
  void linear(const btVector3& direction, double velocity, double lowest, double highest) {
    set(info->m_J1linearAxis, -direction);
    set(info->m_J1angularAxis, -parentArm.cross(direction));
    set(info->m_J2linearAxis, direction);
    set(info->m_J2angularAxis, childArm.cross(direction));
    finish(velocity, lowest, highest);
  }

  // likewise its angular velocity about `direction`
  void angular(const btVector3& direction, double velocity, double lowest, double highest) {
    set(info->m_J1angularAxis, -direction);
    set(info->m_J2angularAxis, direction);
    finish(velocity, lowest, highest);
  }

 private:
  void set(btScalar* rows, const btVector3& value) const {
    for (int i = 0; i < 3; ++i) rows[index * info->rowskip + i] = value[i];
  }
  void finish(double velocity, double lowest, double highest) {
    info->m_constraintError[index * info->rowskip] = velocity;
    info->m_lowerLimit[index * info->rowskip] = lowest;
    info->m_upperLimit[index * info->rowskip] = highest;
    ++index;
  }
};

Joint::Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, *parent.body, *child.body),
      axis_(axisOf(description)),
      turns_(turnsAboutAxis(description.type)),
      slides_(description.type == JointType::kPrismatic),
      linearRows_(heldDirections(description.type)),
      angularRows_(heldTurns(description.type)),
      X_ParentJoint_(alongAxis(parent.X_BodyJoint, axis_.xyz)),
      X_ChildJoint_(alongAxis(child.X_BodyJoint, axis_.xyz)),
      parentMoves_(parent.moves),
      childMoves_(child.moves),
      inertia_(turns_ ? 1 / (1 / inertiaAbout(parent, X_ParentJoint_) + 1 / inertiaAbout(child, X_ChildJoint_))
                      : 1 / (1 / inertiaAlong(parent) + 1 / inertiaAlong(child))) {}

void Joint::setVelocityTarget(double velocity) {
  velocityTarget_ = std::clamp(velocity, -axis_.velocity, axis_.velocity);
}

Joint::Frames Joint::frames() const {
  Frames frames{m_rbA.getWorldTransform() * X_ParentJoint_, m_rbB.getWorldTransform() * X_ChildJoint_, {}};
  frames.axis = frames.X_WorldParent.getBasis().getColumn(0);
  return frames;
}

void Joint::prepare(double dt) {
  motor_.active = false;
  limit_.active = false;
  if (!hasAxis()) return;

  // a spring: explicit, and never stiffer than the step can follow
  double force = force_;
  force_ = 0;
  if (axis_.springStiffness > 0) {
    const double stiffness = std::min(axis_.springStiffness, inertia_ / (dt * dt));
    force += stiffness * (axis_.springReference - state_.position);
  }
  force = std::clamp(force, -axis_.effort, axis_.effort);
  if (force != 0) applyAxisForce(frames(), force);
  appliedForce_ = force;

  // a motor holds its velocity with all its effort; else friction and damping hold against what moves
  if (velocityTarget_) {
    const double impulse = impulseLimit(axis_.effort * dt);
    const double lowest = (axis_.lower - state_.position) / dt;
    const double highest = (axis_.upper - state_.position) / dt;
    motor_ = {true, std::max(std::min(*velocityTarget_, highest), lowest), -impulse, impulse};
  } else if (axis_.friction > 0 || axis_.damping > 0) {
    const double impulse = (axis_.friction + axis_.damping * std::abs(state_.velocity)) * dt;
    motor_ = {true, 0, -impulse, impulse};
  }

  // a limit has a say where this step could reach it; `reach` leaves room for what the step's forces add
  const double reach = (std::abs(state_.velocity) + 1) * 2 * dt;
  if (state_.position < axis_.lower + reach) {
    limit_ = {true, axis_.lower - state_.position, 0, SIMD_INFINITY};
  } else if (state_.position > axis_.upper - reach) {
    limit_ = {true, axis_.upper - state_.position, -SIMD_INFINITY, 0};
  }
}

void Joint::applyAxisForce(const Frames& frames, double force) {
  const btVector3 along = frames.axis * force;
  const auto apply = [&](btRigidBody& body, const btVector3& vector) {
    if (turns_) {
      body.applyTorque(vector);
    } else {
      body.applyForce(vector, frames.X_WorldChild.getOrigin() - body.getWorldTransform().getOrigin());
    }
  };
  if (parentMoves_) apply(m_rbA, -along);
  if (childMoves_) apply(m_rbB, along);
}

void Joint::readReaction(Vector3& force, Vector3& torque) {
  force = torque = Vector3::Zero();
  if (getJointFeedback() == nullptr) {
    feedback_ = {};
    childArm_ = stepAxis_ = btVector3(0, 0, 0);
    setJointFeedback(&feedback_);
    return;
  }
  btVector3 f = feedback_.m_appliedForceBodyB;
  btVector3 t = feedback_.m_appliedTorqueBodyB - childArm_.cross(f);
  (turns_ ? t : f) += stepAxis_ * appliedForce_;
  force = fromBullet(f);
  torque = fromBullet(t);
}

void Joint::transfer(StateArchive& archive) {
  bool hasTarget = velocityTarget_.has_value();
  archive(hasTarget);
  if (archive.isGiving()) velocityTarget_ = hasTarget ? std::optional(0.0) : std::nullopt;
  if (hasTarget) archive(*velocityTarget_);
  archive(force_);
  archive(state_.position);
  archive(state_.velocity);

  bool isMeasured = getJointFeedback() != nullptr;
  archive(isMeasured);
  if (archive.isGiving()) setJointFeedback(isMeasured ? &feedback_ : nullptr);
  archive(appliedForce_);
  for (btVector3* vector : {&feedback_.m_appliedForceBodyA, &feedback_.m_appliedTorqueBodyA,
                            &feedback_.m_appliedForceBodyB, &feedback_.m_appliedTorqueBodyB, &childArm_, &stepAxis_}) {
    transferVector(archive, *vector);
  }
}

void Joint::update() {
  if (!hasAxis()) return;
  const Frames now = frames();
  const btVector3 relativeTurn = m_rbB.getAngularVelocity() - m_rbA.getAngularVelocity();
  if (turns_) {
    // the nearest of all angles that look alike to where it was
    state_.position += std::remainder(angle(now) - state_.position, 2 * std::numbers::pi);
    state_.velocity = now.axis.dot(relativeTurn);
    return;
  }
  const btVector3 point = now.X_WorldChild.getOrigin();
  const btVector3 v_Parent = m_rbA.getVelocityInLocalPoint(point - m_rbA.getWorldTransform().getOrigin());
  const btVector3 v_Child = m_rbB.getVelocityInLocalPoint(point - m_rbB.getWorldTransform().getOrigin());
  state_.position = now.axis.dot(point - now.X_WorldParent.getOrigin());
  state_.velocity = now.axis.dot(v_Child - v_Parent);
}

double Joint::angle(const Frames& frames) const {
  const btVector3 childY = frames.X_WorldChild.getBasis().getColumn(1);
  const btMatrix3x3& parent = frames.X_WorldParent.getBasis();
  return std::atan2(childY.dot(parent.getColumn(2)), childY.dot(parent.getColumn(1)));
}

void Joint::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = linearRows_ + angularRows_ + (motor_.active ? 1 : 0) + (limit_.active ? 1 : 0);
  info->nub = 0;
}

void Joint::getInfo2(btConstraintInfo2* info) {
  const Frames now = frames();
  const btVector3 point = now.X_WorldChild.getOrigin();
  Row row{info, point - m_rbA.getWorldTransform().getOrigin(), point - m_rbB.getWorldTransform().getOrigin()};
  addLinearRows(row, now, info->fps * info->erp);
  addAngularRows(row, now, info->fps * info->erp);
  addAxisRows(row, now, info->fps, info->erp);
  childArm_ = row.childArm;
  stepAxis_ = now.axis;
}

void Joint::addLinearRows(Row& row, const Frames& frames, double errorRate) const {
  const btVector3 gap = frames.X_WorldParent.getOrigin() - frames.X_WorldChild.getOrigin();
  for (int column = 3 - linearRows_; column < 3; ++column) {
    const btVector3 direction = frames.X_WorldParent.getBasis().getColumn(column);
    row.linear(direction, errorRate * gap.dot(direction), -SIMD_INFINITY, SIMD_INFINITY);
  }
}

void Joint::addAngularRows(Row& row, const Frames& frames, double errorRate) const {
  if (angularRows_ == 0) return;
  const btMatrix3x3& parent = frames.X_WorldParent.getBasis();

  // how the parent's frame has to turn to lie as the child's, small: half the sum of the axes' cross products; where
  // only the axes must agree, theirs alone
  btVector3 error = parent.getColumn(0).cross(frames.X_WorldChild.getBasis().getColumn(0));
  if (angularRows_ == 3) {
    for (int column = 1; column < 3; ++column) {
      error += parent.getColumn(column).cross(frames.X_WorldChild.getBasis().getColumn(column));
    }
    error *= 0.5;
  }
  for (int column = 3 - angularRows_; column < 3; ++column) {
    const btVector3 direction = parent.getColumn(column);
    row.angular(direction, -errorRate * error.dot(direction), -SIMD_INFINITY, SIMD_INFINITY);
  }
}

void Joint::addAxisRows(Row& row, const Frames& frames, double fps, double erp) const {
  const auto add = [&](const AxisRow& axisRow, double velocity) {
    if (turns_) {
      row.angular(frames.axis, velocity, axisRow.lowestImpulse, axisRow.highestImpulse);
    } else {
      row.linear(frames.axis, velocity, axisRow.lowestImpulse, axisRow.highestImpulse);
    }
  };
  if (motor_.active) add(motor_, motor_.velocity);
  if (limit_.active) {
    // up to the limit at full speed, back from beyond it bit by bit
    const bool beyond = (limit_.highestImpulse > 0) == (limit_.velocity > 0);
    add(limit_, limit_.velocity * fps * (beyond ? erp : 1));
  }
}

}  // namespace pongsim::physics
