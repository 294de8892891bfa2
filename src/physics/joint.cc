#include "physics/joint.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/convert.hh"
#include "pongsim/geometry/rotation_between.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

using description::JointType;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bullet's own infinity; it does not expect that of IEEE
double impulseLimit(double impulse) { return std::min(impulse, static_cast<double>(SIMD_INFINITY)); }

bool hasTwoAxes(JointType type) { return type == JointType::kUniversal || type == JointType::kRevolute2; }

std::size_t countAxes(JointType type) {
  if (hasTwoAxes(type)) return 2;
  return type == JointType::kBall || type == JointType::kFixed || type == JointType::kGearbox ? 0 : 1;
}

int heldDirections(JointType type) {
  if (type == JointType::kGearbox) return 0;
  return type == JointType::kPrismatic || type == JointType::kScrew ? 2 : 3;
}

int heldTurns(JointType type) {
  if (type == JointType::kBall || type == JointType::kGearbox) return 0;
  if (hasTwoAxes(type)) return 1;
  return type == JointType::kPrismatic || type == JointType::kFixed ? 3 : 2;
}

// turns x into the joint's first axis: y and z are then the held directions
Quaternion turnOf(const description::Joint& joint) {
  if (joint.axes.empty()) return rotationBetween(Vector3::UnitX(), Vector3::UnitZ());
  return rotationBetween(Vector3::UnitX(), joint.axes.front().xyz);
}

btTransform alongAxis(const btTransform& X_BodyJoint, const description::Joint& joint) {
  return X_BodyJoint * btTransform(toBullet(turnOf(joint)));
}

btVector3 secondAxisOf(const description::Joint& joint) {
  if (joint.axes.size() < 2) return {0, 1, 0};
  return toBullet(Vector3(turnOf(joint).conjugate() * joint.axes[1].xyz));
}

// Below this turn in a step [rad] the end of an arm goes straight on. Above the others it does so more and more, and
// then quite: what turns that far in a step has no orbit that could be told.
constexpr double kSmallestTurn = 1e-4;
constexpr double kLargeTurn = 0.5, kLargestTurn = 1;

// What the end of an arm that turns at w for `dt` has of velocity on the mean beyond w x arm: with that, the ends of a
// joint are together where the step ends, in place of each having gone straight on, out of its circle. It is
// (exp(dt w x) - 1) / dt - w x, up to dt^4.
btVector3 bend(const btVector3& arm, const btVector3& w, double dt) {
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

// moment of inertia of the body about an axis through the joint's origin, the axis in the joint frame; infinite if it
// can't move
double inertiaAbout(const JointEnd& end, const btTransform& X_BodyJoint, const btVector3& axisOfJoint) {
  if (!end.moves) return kInfinity;
  const btVector3 axis = X_BodyJoint.getBasis() * axisOfJoint;
  const btVector3 inverse = end.body->getInvInertiaDiagLocal();
  const btVector3 own(axis.x() * axis.x() / inverse.x(), axis.y() * axis.y() / inverse.y(),
                      axis.z() * axis.z() / inverse.z());
  return own.x() + own.y() + own.z() + X_BodyJoint.getOrigin().cross(axis).length2() / end.body->getInvMass();
}

double inertiaAlong(const JointEnd& end) { return end.moves ? 1 / end.body->getInvMass() : kInfinity; }

double inSeries(double a, double b) { return 1 / (1 / a + 1 / b); }

// of the directions about x, that of y is zero
double angleAboutX(const btVector3& v) { return math::atan2(v.z(), v.y()); }

}  // namespace

/// Fills the solver's rows one after the other.
struct Joint::Row {
  btConstraintInfo2* info;
  btVector3 parentArm;
  btVector3 childArm;
  int index = 0;

  // the child's velocity along `direction` at the joint, seen from the parent, less what its turn about it gives by a
  // screw's lead, shall become `velocity`
  void linear(const btVector3& direction, double velocity, double lowest, double highest, double lead = 0) {
    set(info->m_J1linearAxis, -direction);
    set(info->m_J1angularAxis, -parentArm.cross(direction) + lead * direction);
    set(info->m_J2linearAxis, direction);
    set(info->m_J2angularAxis, childArm.cross(direction) - lead * direction);
    finish(velocity, lowest, highest);
  }

  // the turns of the two, weighed by these, shall sum up to `velocity`
  void gears(const btVector3& parent, const btVector3& child, double velocity) {
    set(info->m_J1angularAxis, parent);
    set(info->m_J2angularAxis, child);
    finish(velocity, -SIMD_INFINITY, SIMD_INFINITY);
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

Joint::Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child,
             const JointEnd& reference)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, *parent.body, *child.body),
      type_(description.type),
      axisCount_(std::min(countAxes(description.type), description.axes.size())),
      slides_(description.type == JointType::kPrismatic),
      lead_(description.type == JointType::kScrew ? description.threadPitch / (2 * std::numbers::pi) : 0),
      linearRows_(heldDirections(description.type)),
      angularRows_(heldTurns(description.type)),
      X_ParentJoint_(alongAxis(parent.X_BodyJoint, description)),
      X_ChildJoint_(alongAxis(child.X_BodyJoint, description)),
      secondAxis_(secondAxisOf(description)),
      parentMoves_(parent.moves),
      childMoves_(child.moves) {
  const std::array<btVector3, 2> directions{btVector3(1, 0, 0), secondAxis_};
  for (std::size_t i = 0; i < axisCount_; ++i) {
    axes_[i].description = description.axes[i];
    axes_[i].inertia = inertiaOf(parent, child, directions[i]);
  }
  if (type_ != JointType::kGearbox) return;
  gearbox_ = std::make_unique<Gearbox>(description.gearboxRatio, *reference.body,
                                       alongAxis(reference.X_BodyJoint, description), std::nullopt);
  if (reference.moves && holdsSomething()) gearbox_->part.emplace(*reference.body, parentMoves_ ? m_rbA : m_rbB);
}

double Joint::inertiaOf(const JointEnd& parent, const JointEnd& child, const btVector3& axis) const {
  const double along = inSeries(inertiaAlong(parent), inertiaAlong(child));
  if (slides_) return along;
  const double about = inSeries(inertiaAbout(parent, X_ParentJoint_, axis), inertiaAbout(child, X_ChildJoint_, axis));
  return lead_ == 0 ? about : about + lead_ * lead_ * along;
}

world::JointState Joint::state() const {
  return {axes_[0].position, axes_[0].velocity, axes_[1].position, axes_[1].velocity};
}

void Joint::setVelocityTarget(double velocity, std::size_t axis) {
  const double limit = axes_[axis].description.velocity;
  axes_[axis].velocityTarget = std::clamp(velocity, -limit, limit);
}

bool Joint::isDriven() const {
  return std::ranges::any_of(axes_,
                             [](const Axis& axis) { return axis.force != 0 || axis.velocityTarget.value_or(0) != 0; });
}

void Joint::release() {
  for (Axis& axis : axes_) {
    axis.velocityTarget.reset();
    axis.force = 0;
  }
}

Joint::Axes Joint::axesAlong(const btVector3& first) const {
  if (!hasTwoAxes(type_)) return {{first}, {first}};
  const btVector3 second = m_rbB.getWorldTransform().getBasis() * X_ChildJoint_.getBasis() * secondAxis_;
  const double c = first.dot(second);
  return {{first, second}, {(first - c * second) / (1 - c * c), (second - c * first) / (1 - c * c)}};
}

Joint::Frames Joint::frames() const {
  const btTransform X_WorldParent = m_rbA.getWorldTransform() * X_ParentJoint_;
  return {axesAlong(X_WorldParent.getBasis().getColumn(0)), X_WorldParent, m_rbB.getWorldTransform() * X_ChildJoint_};
}

/// Takes the nearest of all angles that look like this one to where it was [rad].
void Joint::Axis::follow(double angle) { position += std::remainder(angle - position, 2 * std::numbers::pi); }

void Joint::prepare(double dt) {
  if (axisCount_ == 0) return;
  const Axes now = axesAlong(m_rbA.getWorldTransform().getBasis() * X_ParentJoint_.getBasis().getColumn(0));
  for (std::size_t i = 0; i < axisCount_; ++i) {
    Axis& axis = axes_[i];
    prepare(axis, now.drives[i], dt);
    if (axis.appliedForce == 0) continue;
    applyForce(axis.appliedAlong * axis.appliedForce, m_rbB.getWorldTransform()(X_ChildJoint_.getOrigin()));
  }
}

void Joint::prepare(Axis& axis, const btVector3& along, double dt) {
  const description::JointAxis& description = axis.description;
  axis.motor.active = false;
  axis.limit.active = false;

  // a spring: explicit, and never stiffer than the step can follow
  double force = axis.force;
  axis.force = 0;
  if (description.springStiffness > 0) {
    const double stiffness = std::min(description.springStiffness, axis.inertia / (dt * dt));
    force += stiffness * (description.springReference - axis.position);
  }
  axis.appliedForce = std::clamp(force, -description.effort, description.effort);
  axis.appliedAlong = along;

  // a motor holds its velocity with all its effort; else friction and damping hold against what moves
  if (axis.velocityTarget) {
    const double impulse = impulseLimit(description.effort * dt);
    const double lowest = (description.lower - axis.position) / dt;
    const double highest = (description.upper - axis.position) / dt;
    axis.motor = {true, std::max(std::min(*axis.velocityTarget, highest), lowest), -impulse, impulse};
  } else if (description.friction > 0 || description.damping > 0) {
    const double impulse = (description.friction + description.damping * std::abs(axis.velocity)) * dt;
    axis.motor = {true, 0, -impulse, impulse};
  }

  // a limit has a say where this step could reach it; `reach` leaves room for what the step's forces add
  const double reach = (std::abs(axis.velocity) + 1) * 2 * dt;
  if (axis.position < description.lower + reach) {
    axis.limit = {true, description.lower - axis.position, 0, SIMD_INFINITY};
  } else if (axis.position > description.upper - reach) {
    axis.limit = {true, description.upper - axis.position, -SIMD_INFINITY, 0};
  }
}

void Joint::applyForce(const btVector3& force, const btVector3& point) {
  const auto apply = [&](btRigidBody& body, const btVector3& vector) {
    if (slides_) {
      body.applyForce(vector, point - body.getWorldTransform().getOrigin());
    } else {
      body.applyTorque(vector);
    }
  };
  if (parentMoves_) apply(m_rbA, -force);
  if (childMoves_) apply(m_rbB, force);
}

void Joint::readReaction(Vector3& force, Vector3& torque) {
  force = torque = Vector3::Zero();
  if (getJointFeedback() == nullptr) {
    feedback_ = noFeedback();
    childArm_ = btVector3(0, 0, 0);
    for (Axis& axis : axes_) axis.appliedForce = 0;
    setJointFeedback(&feedback_);
    return;
  }
  btVector3 f = feedback_.m_appliedForceBodyB;
  btVector3 t = feedback_.m_appliedTorqueBodyB - childArm_.cross(f);
  for (std::size_t i = 0; i < axisCount_; ++i) (slides_ ? f : t) += axes_[i].appliedAlong * axes_[i].appliedForce;
  force = fromBullet(f);
  torque = fromBullet(t);
}

void Joint::transfer(StateArchive& archive) {
  for (Axis& axis : axes_) {
    bool hasTarget = axis.velocityTarget.has_value();
    archive(hasTarget);
    if (archive.isGiving()) axis.velocityTarget = hasTarget ? std::optional(0.0) : std::nullopt;
    if (hasTarget) archive(*axis.velocityTarget);
    for (double* value : {&axis.force, &axis.position, &axis.velocity, &axis.appliedForce}) archive(*value);
    transferVector(archive, axis.appliedAlong);
  }

  bool isMeasured = getJointFeedback() != nullptr;
  archive(isMeasured);
  if (archive.isGiving()) setJointFeedback(isMeasured ? &feedback_ : nullptr);
  for (btVector3* vector : {&feedback_.m_appliedForceBodyA, &feedback_.m_appliedTorqueBodyA,
                            &feedback_.m_appliedForceBodyB, &feedback_.m_appliedTorqueBodyB, &childArm_}) {
    transferVector(archive, *vector);
  }
}

void Joint::update() {
  if (gearbox_) updateGears();
  if (axisCount_ == 0) return;
  if (!slides_ && !hasTwoAxes(type_)) {
    updateTurn();
    return;
  }
  const Frames now = frames();
  if (slides_) {
    const btVector3 point = now.X_WorldChild.getOrigin();
    const btVector3 v_Parent = m_rbA.getVelocityInLocalPoint(point - m_rbA.getWorldTransform().getOrigin());
    const btVector3 v_Child = m_rbB.getVelocityInLocalPoint(point - m_rbB.getWorldTransform().getOrigin());
    axes_[0].position = offset(now);
    axes_[0].velocity = now.axes[0].dot(v_Child - v_Parent);
    return;
  }
  const btVector3 relativeTurn = m_rbB.getAngularVelocity() - m_rbA.getAngularVelocity();
  const std::array<double, 2> found = angles(now);
  for (std::size_t i = 0; i < axisCount_; ++i) {
    axes_[i].follow(found[i]);
    axes_[i].velocity = now.drives[i].dot(relativeTurn);
  }
}

/// Of a joint that turns about one axis.
void Joint::updateTurn() {
  const btMatrix3x3 parent = m_rbA.getWorldTransform().getBasis() * X_ParentJoint_.getBasis();
  const btVector3 side = m_rbB.getWorldTransform().getBasis() * X_ChildJoint_.getBasis().getColumn(1);
  axes_[0].follow(angleAboutX(side * parent));
  axes_[0].velocity = parent.getColumn(0).dot(m_rbB.getAngularVelocity() - m_rbA.getAngularVelocity());
}

void Joint::updateGears() {
  const btMatrix3x3 R_WorldReference = (gearbox_->body.getWorldTransform() * gearbox_->X_BodyJoint).getBasis();
  const Frames now = frames();
  const std::array<const btMatrix3x3*, 2> gears{&now.X_WorldParent.getBasis(), &now.X_WorldChild.getBasis()};
  const std::array<const btRigidBody*, 2> bodies{&m_rbA, &m_rbB};
  const std::array<btVector3, 2> directions{btVector3(1, 0, 0), secondAxis_};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    const double found = turnAbout(directions[i], R_WorldReference, *gears[i]);
    axis.follow(found);
    const btVector3 relativeTurn = bodies[i]->getAngularVelocity() - gearbox_->body.getAngularVelocity();
    axis.velocity = relativeTurn.dot(R_WorldReference * directions[i]);
  }
}

double Joint::offset(const Frames& frames) const {
  return frames.axes[0].dot(frames.X_WorldChild.getOrigin() - frames.X_WorldParent.getOrigin());
}

std::array<double, 2> Joint::angles(const Frames& frames) const {
  const btMatrix3x3& parent = frames.X_WorldParent.getBasis();
  const btMatrix3x3& child = frames.X_WorldChild.getBasis();
  // how far the second axis has turned about the first, and against what the first has about the second
  const double first = angleAboutX(frames.axes[1] * parent) - angleAboutX(secondAxis_);
  const btVector3 start = btVector3(1, 0, 0) - secondAxis_.x() * secondAxis_;
  const btVector3 now = frames.axes[0] * child;
  return {first, -math::atan2(now.dot(secondAxis_.cross(start)), now.dot(start))};
}

void Joint::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = linearRows_ + angularRows_ + (type_ == JointType::kScrew || gearbox_ ? 1 : 0);
  for (const Axis& axis : axes_) info->m_numConstraintRows += (axis.motor.active ? 1 : 0) + (axis.limit.active ? 1 : 0);
  info->nub = 0;
}

void Joint::getInfo2(btConstraintInfo2* info) {
  const Frames now = frames();
  const btVector3 point = now.X_WorldChild.getOrigin();
  Row row{info, point - m_rbA.getWorldTransform().getOrigin(), point - m_rbB.getWorldTransform().getOrigin()};
  const double errorRate = info->fps * info->erp;
  if (gearbox_) addGearRow(row, errorRate);
  const double dt = 1 / info->fps;
  addLinearRows(
      row, now, errorRate,
      bend(row.parentArm, m_rbA.getAngularVelocity(), dt) - bend(row.childArm, m_rbB.getAngularVelocity(), dt));
  if (hasTwoAxes(type_)) {
    addCrossRow(row, now, errorRate);
  } else {
    addAngularRows(row, now, errorRate);
  }
  for (std::size_t i = 0; i < axisCount_; ++i) addAxisRows(row, axes_[i], now.drives[i], info->fps, info->erp);
  childArm_ = row.childArm;
}

// ratio theta1 + theta2 = 0, each turn seen from the reference body
void Joint::addGearRow(Row& row, double errorRate) {
  const btMatrix3x3 R_WorldReference = (gearbox_->body.getWorldTransform() * gearbox_->X_BodyJoint).getBasis();
  const btVector3 first = gearbox_->ratio * R_WorldReference.getColumn(0);
  const btVector3 second = R_WorldReference * secondAxis_;
  row.gears(first, second, -errorRate * (gearbox_->ratio * axes_[0].position + axes_[1].position));
  if (gearbox_->part) gearbox_->part->setTorque(-first - second);
}

void Joint::addLinearRows(Row& row, const Frames& frames, double errorRate, const btVector3& bent) const {
  const btVector3 gap = frames.X_WorldParent.getOrigin() - frames.X_WorldChild.getOrigin();
  for (int column = 3 - linearRows_; column < 3; ++column) {
    const btVector3 direction = frames.X_WorldParent.getBasis().getColumn(column);
    row.linear(direction, errorRate * gap.dot(direction) + bent.dot(direction), -SIMD_INFINITY, SIMD_INFINITY);
  }
  if (type_ != JointType::kScrew) return;
  const double error = offset(frames) - lead_ * axes_[0].position;
  row.linear(frames.axes[0], -errorRate * error, -SIMD_INFINITY, SIMD_INFINITY, lead_);
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

// the angle between two axes stays
void Joint::addCrossRow(Row& row, const Frames& frames, double errorRate) const {
  const btVector3 cross = frames.axes[0].cross(frames.axes[1]);
  const double sine = cross.length();
  const double error = (frames.axes[0].dot(frames.axes[1]) - secondAxis_.x()) / sine;
  row.angular(cross / sine, errorRate * error, -SIMD_INFINITY, SIMD_INFINITY);
}

void Joint::addAxisRows(Row& row, const Axis& axis, const btVector3& along, double fps, double erp) const {
  const auto add = [&](const AxisRow& axisRow, double velocity) {
    if (slides_) {
      row.linear(along, velocity, axisRow.lowestImpulse, axisRow.highestImpulse);
    } else {
      row.angular(along, velocity, axisRow.lowestImpulse, axisRow.highestImpulse);
    }
  };
  if (axis.motor.active) add(axis.motor, axis.motor.velocity);
  if (axis.limit.active) {
    // up to the limit at full speed, back from beyond it bit by bit
    const bool beyond = (axis.limit.highestImpulse > 0) == (axis.limit.velocity > 0);
    add(axis.limit, axis.limit.velocity * fps * (beyond ? erp : 1));
  }
}

}  // namespace pongsim::physics
