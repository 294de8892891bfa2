#include "physics/joint.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "description/limits.hh"
#include "physics/convert.hh"
#include "pongsim/geometry/rotation_between.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

using description::JointType;

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

// rotates x to the joint's first axis, so that y and z are the constrained directions
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

// A number or infinity, of which archives read only the former.
void transferBound(StateArchive& archive, double& bound) {
  bool isInfinite = std::isinf(bound);
  bool isNegative = bound < 0;
  archive(isInfinite);
  archive(isNegative);
  double finite = isInfinite ? 0 : bound;
  archive(finite);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (archive.isGiving()) bound = !isInfinite ? finite : isNegative ? -kInfinity : kInfinity;
}

// angle of a vector about x, counted from y
double angleAboutX(const btVector3& v) { return math::atan2(v.z(), v.y()); }

// The rotation of a frame about one of its unit vectors, relative to a reference frame that it was aligned with at the
// start [rad], between -pi and pi: the twist of the swing-twist decomposition of the relative rotation. The axis may be
// given in either frame, at the start.
double twistAbout(const btVector3& axis, const btMatrix3x3& R_WorldReference, const btMatrix3x3& R_WorldGear) {
  btQuaternion turn;
  (R_WorldReference.transpose() * R_WorldGear).getRotation(turn);
  const double sine = btVector3(turn.x(), turn.y(), turn.z()).dot(axis);
  return std::remainder(2 * math::atan2(sine, turn.w()), 2 * std::numbers::pi);
}

}  // namespace

Joint::Limits::Limits(const description::JointAxis& axis)
    : lower(axis.lower),
      upper(axis.upper),
      effort(axis.effort),
      velocity(axis.velocity),
      damping(axis.damping),
      friction(axis.friction),
      springReference(axis.springReference),
      springStiffness(axis.springStiffness) {}

Joint::Joint(const description::Joint& description, const JointEnd& parent, const JointEnd& child,
             const JointEnd& reference)
    : parent_(*parent.body),
      child_(*child.body),
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
  for (std::size_t i = 0; i < axisCount_; ++i) axes_[i].limits = axes_[i].ofFile = Limits(description.axes[i]);
  if (type_ != JointType::kGearbox) return;
  gearbox_ = std::make_unique<Gearbox>(description.gearboxRatio, *reference.body, reference.moves,
                                       alongAxis(reference.X_BodyJoint, description));
}

world::JointState Joint::state() const {
  return {axes_[0].position, axes_[0].velocity, axes_[1].position, axes_[1].velocity};
}

void Joint::setVelocityTarget(double velocity, std::size_t axis) {
  const double limit = axes_[axis].limits.velocity;
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
  const btVector3 second = child_.getWorldTransform().getBasis() * X_ChildJoint_.getBasis() * secondAxis_;
  const double c = first.dot(second);
  return {{first, second}, {(first - c * second) / (1 - c * c), (second - c * first) / (1 - c * c)}};
}

Joint::Frames Joint::frames() const {
  const btTransform X_WorldParent = parent_.getWorldTransform() * X_ParentJoint_;
  return {axesAlong(X_WorldParent.getBasis().getColumn(0)), X_WorldParent, child_.getWorldTransform() * X_ChildJoint_};
}

/// Takes the angle [rad] plus the number of whole turns that is nearest to the position.
void Joint::Axis::unwrap(double angle) {
  const double change = angle - position;
  // most of the time that is the remainder itself
  position += std::abs(change) < std::numbers::pi ? change : std::remainder(change, 2 * std::numbers::pi);
}

void Joint::prepare(double dt) {
  if (axisCount_ == 0) return;
  const Axes now = axesAlong(parent_.getWorldTransform().getBasis() * X_ParentJoint_.getBasis().getColumn(0));
  for (std::size_t i = 0; i < axisCount_; ++i) {
    Axis& axis = axes_[i];
    prepare(axis, now.drives[i], dt);
    if (axis.appliedForce == 0) continue;
    applyForce(axis.appliedAlong * axis.appliedForce, child_.getWorldTransform()(X_ChildJoint_.getOrigin()));
  }
}

void Joint::prepare(Axis& axis, const btVector3& along, double dt) {
  const Limits& limits = axis.limits;
  axis.motor.active = axis.damper.active = false;
  axis.appliedForce = std::clamp(std::exchange(axis.force, 0), -limits.effort, limits.effort);
  axis.appliedAlong = along;

  // a motor holds its velocity with all its effort; else friction holds against what moves
  const std::optional<double> target = targetOf(axis, dt);
  if (target) {
    const double impulse = limits.effort * dt;
    const double lowest = (limits.lower - axis.position) / dt;
    const double highest = (limits.upper - axis.position) / dt;
    axis.motor = {true, std::max(std::min(*target, highest), lowest), -impulse, impulse};
  } else if (limits.friction > 0) {
    axis.motor = {true, 0, -limits.friction * dt, limits.friction * dt};
  }
  const bool isHeld = target && std::isinf(limits.effort);
  if (!isHeld) prepareDamper(axis, dt);

  axis.stops = stopsOf(axis, dt);
}

Joint::Stops Joint::stopsOf(const Axis& axis, double dt) {
  const Limits& limits = axis.limits;
  if (limits.lower == limits.upper) return Stops::kLocked;
  // the 1 allows for what the forces add to the velocity
  const double reach = (std::abs(axis.velocity) + 1) * 2 * dt;
  const bool reachesLower = axis.position < limits.lower + reach;
  const bool reachesUpper = axis.position > limits.upper - reach;
  if (reachesLower && reachesUpper) return Stops::kBoth;
  if (reachesLower) return Stops::kLower;
  return reachesUpper ? Stops::kUpper : Stops::kNone;
}

/// @return The velocity that the axis is driven at: the commanded one, or the one that takes it to where it mimics the
/// leader to be at the end of the step. As with DART's mimic motor, the leader does not feel it.
std::optional<double> Joint::targetOf(const Axis& axis, double dt) {
  if (axis.velocityTarget || axis.leader == nullptr) return axis.velocityTarget;
  const description::Mimic& mimic = *axis.mimic;
  const Axis& leader = axis.leader->axes_[mimic.axis];
  const double position = leader.position + dt * leader.velocity;
  const double target = mimic.multiplier * (position - mimic.reference) + mimic.offset;
  const double limit = axis.limits.velocity;
  return std::clamp((target - axis.position) / dt, -limit, limit);
}

/// Spring k and damper d act at the end of the step h, so that they are stable for any inertia, as in Fortress's DART:
/// the impulse is -h (k (q + h v - q0) + d v), so v + impulse / (h d + h^2 k) = -k (q - q0) / (d + h k).
void Joint::prepareDamper(Axis& axis, double dt) {
  const Limits& limits = axis.limits;
  const double sum = limits.damping + dt * limits.springStiffness;
  if (!(sum > 0)) return;
  const double stretch = axis.position - limits.springReference;
  axis.damper = {true, -limits.springStiffness * stretch / sum, 1 / (dt * sum)};
}

void Joint::applyForce(const btVector3& force, const btVector3& point) {
  const auto apply = [&](btRigidBody& body, const btVector3& vector) {
    if (slides_) {
      body.applyForce(vector, point - body.getWorldTransform().getOrigin());
    } else {
      body.applyTorque(vector);
    }
  };
  if (parentMoves_) apply(parent_, -force);
  if (childMoves_) apply(child_, force);
}

void Joint::readReaction(Vector3& force, Vector3& torque) {
  force = torque = Vector3::Zero();
  if (!isMeasured_) {
    isMeasured_ = true;
    force_ = torque_ = childArm_ = btVector3(0, 0, 0);
    for (Axis& axis : axes_) axis.appliedForce = 0;
    return;
  }
  btVector3 f = force_;
  btVector3 t = torque_ - childArm_.cross(f);
  for (std::size_t i = 0; i < axisCount_; ++i) (slides_ ? f : t) += axes_[i].appliedAlong * axes_[i].appliedForce;
  force = fromBullet(f);
  torque = fromBullet(t);
}

void Joint::setReaction(const btVector3& force, const btVector3& torque) {
  force_ = force;
  torque_ = torque;
}

void Joint::transfer(StateArchive& archive) {
  for (Axis& axis : axes_) {
    bool hasTarget = axis.velocityTarget.has_value();
    archive(hasTarget);
    if (archive.isGiving()) axis.velocityTarget = hasTarget ? std::optional(0.0) : std::nullopt;
    if (hasTarget) archive(*axis.velocityTarget);
    for (double* value : {&axis.force, &axis.position, &axis.velocity, &axis.appliedForce}) archive(*value);
    archive(axis.areLimitsChanged);
    if (axis.areLimitsChanged) {
      Limits& limits = axis.limits;
      archive(limits.damping);
      archive(limits.friction);
      for (double* bound : {&limits.lower, &limits.upper, &limits.effort}) transferBound(archive, *bound);
      archive.check(limits.damping >= 0 && limits.friction >= 0 && limits.lower <= limits.upper && limits.effort >= 0);
    } else if (archive.isGiving()) {
      axis.limits = axis.ofFile;
    }
    transferVector(archive, axis.appliedAlong);
    archive.check(std::abs(axis.velocityTarget.value_or(0)) <= description::kFastestSaved &&
                  std::abs(axis.velocity) <= description::kFastestSaved &&
                  std::abs(axis.force) <= description::kStrongestSaved);
  }
  archive(isMeasured_);
  for (btVector3* vector : {&force_, &torque_, &childArm_}) transferVector(archive, *vector);
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
    const btVector3 v_Parent = parent_.getVelocityInLocalPoint(point - parent_.getWorldTransform().getOrigin());
    const btVector3 v_Child = child_.getVelocityInLocalPoint(point - child_.getWorldTransform().getOrigin());
    axes_[0].position = offset(now);
    axes_[0].velocity = now.axes[0].dot(v_Child - v_Parent);
    return;
  }
  const btVector3 relativeTurn = child_.getAngularVelocity() - parent_.getAngularVelocity();
  const std::array<double, 2> found = angles(now);
  for (std::size_t i = 0; i < axisCount_; ++i) {
    axes_[i].unwrap(found[i]);
    axes_[i].velocity = now.drives[i].dot(relativeTurn);
  }
}

/// Of a joint that turns about one axis.
void Joint::updateTurn() {
  const btMatrix3x3 parent = parent_.getWorldTransform().getBasis() * X_ParentJoint_.getBasis();
  const btVector3 side = child_.getWorldTransform().getBasis() * X_ChildJoint_.getBasis().getColumn(1);
  axes_[0].unwrap(angleAboutX(side * parent));
  axes_[0].velocity = parent.getColumn(0).dot(child_.getAngularVelocity() - parent_.getAngularVelocity());
}

/// @return The frame of a gearbox's reference body, with x along the first axis.
btMatrix3x3 Joint::gearboxBasis() const {
  return (gearbox_->body.getWorldTransform() * gearbox_->X_BodyJoint).getBasis();
}

void Joint::updateGears() {
  const btMatrix3x3 R_WorldReference = gearboxBasis();
  const Frames now = frames();
  const std::array<const btMatrix3x3*, 2> gears{&now.X_WorldParent.getBasis(), &now.X_WorldChild.getBasis()};
  const std::array<const btRigidBody*, 2> bodies{&parent_, &child_};
  const std::array<btVector3, 2> directions{btVector3(1, 0, 0), secondAxis_};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    const double found = twistAbout(directions[i], R_WorldReference, *gears[i]);
    axis.unwrap(found);
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
  // the rotation of the second axis about the first, and the negative of that of the first about the second
  const double first = angleAboutX(frames.axes[1] * parent) - angleAboutX(secondAxis_);
  const btVector3 start = btVector3(1, 0, 0) - secondAxis_.x() * secondAxis_;
  const btVector3 now = frames.axes[0] * child;
  return {first, -math::atan2(now.dot(secondAxis_.cross(start)), now.dot(start))};
}

}  // namespace pongsim::physics
