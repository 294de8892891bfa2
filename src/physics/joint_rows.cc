// The constraint rows of joints.

#include <cassert>
#include <cmath>

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
  for (std::size_t i = 0; i < axisCount_; ++i) addAxisRows(writer, axes_[i], now.drives[i], rate, erp);
  assert(writer.count == rowCount());
  return rows.first(writer.count);
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
  const btMatrix3x3& parent = frames.X_WorldParent.getBasis();

  // the small rotation from the parent's frame to the child's: half the sum of the cross products of their axes, or,
  // if only the first axes are held together, their cross product
  btVector3 error = parent.getColumn(0).cross(frames.X_WorldChild.getBasis().getColumn(0));
  if (angularRows_ == 3) {
    for (int column = 1; column < 3; ++column) {
      error += parent.getColumn(column).cross(frames.X_WorldChild.getBasis().getColumn(column));
    }
    error *= 0.5;
  }
  for (int column = 3 - angularRows_; column < 3; ++column) {
    const btVector3 direction = parent.getColumn(column);
    writer.angular(direction, -errorRate * error.dot(direction), -kInfinity, kInfinity);
  }
}

// keeps the angle between the two axes
void Joint::addCrossRow(RowWriter& writer, const Frames& frames, double errorRate) const {
  const btVector3 cross = frames.axes[0].cross(frames.axes[1]);
  const double sine = cross.length();
  const double error = (frames.axes[0].dot(frames.axes[1]) - secondAxis_.x()) / sine;
  writer.angular(cross / sine, errorRate * error, -kInfinity, kInfinity);
}

void Joint::addAxisRows(RowWriter& writer, const Axis& axis, const btVector3& along, double rate, double erp) const {
  const auto add = [&](double bias, double lowest, double highest, double compliance = 0) {
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
