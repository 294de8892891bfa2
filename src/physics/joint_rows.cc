// The constraint rows of joints.

#include <cassert>
#include <cmath>
#include <utility>

#include "physics/joint.hh"

namespace pongsim::physics {

namespace {

using description::JointType;

// Turns per step [rad]: below the first the correction is not worth its cost; from the second to the third it fades
// out, because beyond, a step does not resolve the circle any more.
constexpr double kSmallestTurn = 1e-4;
constexpr double kLargeTurn = 0.5, kLargestTurn = 1;

// The end of an arm r that turns at w moves along a circle, and in `dt` by (exp(dt [w]) - 1) r, where [w] is the matrix
// of w x. So its mean velocity is not w x r but
//   (exp(dt [w]) - 1) r / dt = w x r + dt/2 [w]^2 r + dt^2/6 [w]^3 r + ...
// With the terms behind the first as bias, the ends of a joint meet at the end of the step.
// Returns these, up to dt^4.
btVector3 chordVelocity(const btVector3& arm, const btVector3& w, double dt) {
  const double turn2 = w.length2() * dt * dt;
  if (turn2 < kSmallestTurn * kSmallestTurn || turn2 > kLargestTurn * kLargestTurn) return {0, 0, 0};
  btVector3 sum(0, 0, 0);
  btVector3 term = w.cross(arm);
  for (int k = 2; k <= 5; ++k) {
    term = (dt / k) * w.cross(term);
    sum += term;
  }
  if (turn2 <= kLargeTurn * kLargeTurn) return sum;
  return (kLargestTurn - std::sqrt(turn2)) / (kLargestTurn - kLargeTurn) * sum;
}

}  // namespace

/// Writes rows one after the other.
struct Joint::RowWriter {
  std::span<JointRow, kMostRows> rows;
  btVector3 parentArm;
  btVector3 childArm;
  std::size_t count = 0;

  /// The child's velocity along `direction` at the joint, relative to the parent; of a screw, less `lead` times the
  /// relative angular velocity about it.
  void linear(const btVector3& direction, double bias, double lowest, double highest, double lead = 0,
              double compliance = 0) {
    add({direction,
         -parentArm.cross(direction) + lead * direction,
         childArm.cross(direction) - lead * direction,
         {},
         bias,
         lowest,
         highest,
         compliance});
  }

  /// The child's angular velocity about `direction`, relative to the parent.
  void angular(const btVector3& direction, double bias, double lowest, double highest, double compliance = 0) {
    add({btVector3(0, 0, 0), -direction, direction, {}, bias, lowest, highest, compliance});
  }

  /// The weighted sum of the angular velocities of parent and child, relative to the reference body.
  void gears(const btVector3& parent, const btVector3& child, double bias) {
    add({btVector3(0, 0, 0), parent, child, -parent - child, bias, -kInfinity, kInfinity});
  }

 private:
  void add(const JointRow& row) {
    assert(count < rows.size());
    assert(row.lowest <= row.highest && std::isfinite(row.bias));
    rows[count++] = row;
  }
};

std::size_t Joint::rowCount() const {
  std::size_t count = static_cast<std::size_t>(linearRows_ + angularRows_);
  if (type_ == JointType::kScrew || gearbox_) ++count;
  for (const Axis& axis : axes_) {
    count += (axis.motor.active ? 1 : 0) + (axis.damper.active ? 1 : 0);
    if (axis.stops != Stops::kNone) count += axis.stops == Stops::kBoth ? 2 : 1;
  }
  return count;
}

std::span<const JointRow> Joint::rows(double dt, double erp, std::span<JointRow, kMostRows> rows) {
  const Frames now = frames();
  const btVector3 point = now.X_WorldChild.getOrigin();
  childArm_ = point - child_.getWorldTransform().getOrigin();
  RowWriter writer{rows, point - parent_.getWorldTransform().getOrigin(), childArm_};
  const double rate = 1 / dt;
  const double errorRate = rate * erp;
  if (gearbox_) addGearRow(writer, errorRate);
  addLinearRows(writer, now, errorRate,
                chordVelocity(writer.parentArm, parent_.getAngularVelocity(), dt) -
                    chordVelocity(writer.childArm, child_.getAngularVelocity(), dt));
  if (angularRows_ == 1) {
    addCrossRow(writer, now, errorRate);
  } else {
    addAngularRows(writer, now, errorRate);
  }
  for (std::size_t i = 0; i < axisCount_; ++i) addAxisRows(writer, axes_[i], now.drives[i], rate, erp, true);
  assert(writer.count == rowCount());
  return rows.first(writer.count);
}

std::span<const JointRow> Joint::motion(double dt, double erp, JointMotion& motion,
                                        std::span<JointRow, kMostRows> rows) {
  assert(!gearbox_);
  const Frames now = frames();
  const btVector3 point = now.X_WorldChild.getOrigin();
  childArm_ = motion.childArm = point - child_.getWorldTransform().getOrigin();
  motion.parentArm = point - parent_.getWorldTransform().getOrigin();
  const double rate = 1 / dt;
  motion.linear = heldVelocity(now, rate * erp,
                               chordVelocity(motion.parentArm, parent_.getAngularVelocity(), dt) -
                                   chordVelocity(motion.childArm, child_.getAngularVelocity(), dt));
  motion.angular = heldTurn(now, rate * erp);
  RowWriter writer{rows, motion.parentArm, motion.childArm};
  motion.count = 0;
  for (std::size_t i = 0; i < axisCount_; ++i) {
    addFreedom(motion, axes_[i], now.axes[i], rate * erp);
    addAxisRows(writer, axes_[i], now.drives[i], rate, erp, false);
  }
  if (type_ == JointType::kBall) {
    for (const btVector3& axis : {btVector3(1, 0, 0), btVector3(0, 1, 0), btVector3(0, 0, 1)}) {
      motion.freedoms[motion.count++] = {btVector3(0, 0, 0), axis};
    }
  }
  return rows.first(writer.count);
}

/// Adds the freedom of an axis, or the velocity at which it is held.
void Joint::addFreedom(JointMotion& motion, const Axis& axis, const btVector3& along, double errorRate) const {
  const JointMotion::Freedom freedom{slides_ ? along : lead_ * along, slides_ ? btVector3(0, 0, 0) : along};
  const bool isLocked = axis.stops == Stops::kLocked;
  if (isLocked || (axis.motor.active && std::isinf(axis.motor.highestImpulse))) {
    const double velocity = isLocked ? errorRate * (axis.limits.lower - axis.position) : axis.motor.velocity;
    motion.linear += velocity * freedom.linear;
    motion.angular += velocity * freedom.angular;
    return;
  }
  motion.freedoms[motion.count] = freedom;
  if (axis.damper.active) {
    motion.freedoms[motion.count].damping = 1 / axis.damper.compliance;
    motion.freedoms[motion.count].velocity = axis.damper.velocity;
  }
  ++motion.count;
}

/// @return What the linear rows ask for: that the ends meet.
btVector3 Joint::heldVelocity(const Frames& frames, double errorRate, const btVector3& chordVelocity) const {
  const btVector3 all =
      errorRate * (frames.X_WorldParent.getOrigin() - frames.X_WorldChild.getOrigin()) + chordVelocity;
  if (linearRows_ == 3) return all;
  const btVector3& axis = frames.axes[0];
  double along = 0;
  if (type_ == JointType::kScrew) along = -errorRate * (offset(frames) - lead_ * axes_[0].position);
  return all + (along - all.dot(axis)) * axis;
}

/// Likewise of the angular rows.
btVector3 Joint::heldTurn(const Frames& frames, double errorRate) const {
  if (angularRows_ == 0) return {0, 0, 0};
  if (angularRows_ == 1) {
    const auto [direction, error] = crossError(frames);
    return errorRate * error * direction;
  }
  const btVector3 all = -errorRate * angularError(frames);
  if (angularRows_ == 3) return all;
  return all - all.dot(frames.axes[0]) * frames.axes[0];
}

// ratio theta1 + theta2 = 0, both angles relative to the reference body
void Joint::addGearRow(RowWriter& writer, double errorRate) const {
  const btMatrix3x3 R_WorldReference = gearboxBasis();
  writer.gears(gearbox_->ratio * R_WorldReference.getColumn(0), R_WorldReference * secondAxis_,
               -errorRate * (gearbox_->ratio * axes_[0].position + axes_[1].position));
}

void Joint::addLinearRows(RowWriter& writer, const Frames& frames, double errorRate,
                          const btVector3& chordVelocity) const {
  const btVector3 gap = frames.X_WorldParent.getOrigin() - frames.X_WorldChild.getOrigin();
  for (int column = 3 - linearRows_; column < 3; ++column) {
    const btVector3 direction = frames.X_WorldParent.getBasis().getColumn(column);
    writer.linear(direction, errorRate * gap.dot(direction) + chordVelocity.dot(direction), -kInfinity, kInfinity);
  }
  if (type_ != JointType::kScrew) return;
  const double error = offset(frames) - lead_ * axes_[0].position;
  writer.linear(frames.axes[0], -errorRate * error, -kInfinity, kInfinity, lead_);
}

void Joint::addAngularRows(RowWriter& writer, const Frames& frames, double errorRate) const {
  if (angularRows_ == 0) return;
  const btVector3 error = angularError(frames);
  for (int column = 3 - angularRows_; column < 3; ++column) {
    const btVector3 direction = frames.X_WorldParent.getBasis().getColumn(column);
    writer.angular(direction, -errorRate * error.dot(direction), -kInfinity, kInfinity);
  }
}

/// @return The small rotation from the parent's frame to the child's: half the sum of the cross products of their axes,
/// or, if only the first axes are held together, their cross product.
btVector3 Joint::angularError(const Frames& frames) const {
  const btMatrix3x3& parent = frames.X_WorldParent.getBasis();
  btVector3 error = parent.getColumn(0).cross(frames.X_WorldChild.getBasis().getColumn(0));
  if (angularRows_ == 3) {
    for (int column = 1; column < 3; ++column) {
      error += parent.getColumn(column).cross(frames.X_WorldChild.getBasis().getColumn(column));
    }
    error *= 0.5;
  }
  return error;
}

void Joint::addCrossRow(RowWriter& writer, const Frames& frames, double errorRate) const {
  const auto [direction, error] = crossError(frames);
  writer.angular(direction, errorRate * error, -kInfinity, kInfinity);
}

/// @return The direction across both axes, and by what angle about it these are too close.
std::pair<btVector3, double> Joint::crossError(const Frames& frames) const {
  const btVector3 cross = frames.axes[0].cross(frames.axes[1]);
  const double sine = cross.length();
  return {cross / sine, (frames.axes[0].dot(frames.axes[1]) - secondAxis_.x()) / sine};
}

/// @param withEquations Whether those without bounds are among them.
void Joint::addAxisRows(RowWriter& writer, const Axis& axis, const btVector3& along, double rate, double erp,
                        bool withEquations) const {
  const auto add = [&](double bias, double lowest, double highest, double compliance = 0) {
    if (!withEquations && std::isinf(lowest) && std::isinf(highest)) return;
    if (slides_) {
      writer.linear(along, bias, lowest, highest, 0, compliance);
    } else {
      writer.angular(along, bias, lowest, highest, compliance);
    }
  };
  if (axis.motor.active) add(axis.motor.velocity, axis.motor.lowestImpulse, axis.motor.highestImpulse);
  if (axis.damper.active) add(axis.damper.velocity, -kInfinity, kInfinity, axis.damper.compliance);
  // reach a limit within this step, but return from beyond it by the fraction `erp`
  const double toLower = axis.limits.lower - axis.position, toUpper = axis.limits.upper - axis.position;
  if (axis.stops == Stops::kLocked) add(toLower * rate * erp, -kInfinity, kInfinity);
  if (axis.stops == Stops::kLower || axis.stops == Stops::kBoth) {
    add(toLower * rate * (toLower > 0 ? erp : 1), 0, kInfinity);
  }
  if (axis.stops == Stops::kUpper || axis.stops == Stops::kBoth) {
    add(toUpper * rate * (toUpper > 0 ? 1 : erp), -kInfinity, 0);
  }
}

}  // namespace pongsim::physics
