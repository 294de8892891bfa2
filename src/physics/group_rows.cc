#include "physics/group_rows.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "physics/bounce.hh"
#include "physics/friction.hh"
#include "physics/gearbox.hh"
#include "physics/motion.hh"
#include "physics/rounding.hh"
#include "physics/settings.hh"

namespace pongsim::physics {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// More than any joint has.
constexpr std::size_t kMostRowsOfJoint = 16;

// Of a contact in its normal direction, by the mass that it moves. A body that stands on more points than three, as a
// robot on two wheels and two casters, so spreads its weight over them all. Were its points rigid, a difference of
// nanometres would lift the wheels off the ground, and they would spin.
constexpr double kContactSoftness = 1e-4;

// below that a row's stiffness is rounding [1/kg]
constexpr double kSmallestStiffness = SIMD_EPSILON;

// Of what penetration turns bodies by, Bullet takes that part.
constexpr double kTurnReduction = 0.1;

// below that, a turn [rad] is put on the matrix as it is
constexpr double kSmallTurnApart = 1e-4;

// the method's infinity is that of IEEE, the rows' the largest number
double bound(double limit) { return std::abs(limit) >= SIMD_INFINITY ? std::copysign(kNoBound, limit) : limit; }

btVector3 vectorOf(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }

double dotOf(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  const double even = a[0] * b[0] + a[2] * b[2] + a[4] * b[4];
  const double odd = a[1] * b[1] + a[3] * b[3] + a[5] * b[5];
  return even + odd;
}

void clear(btJointFeedback& feedback) {
  feedback.m_appliedForceBodyA = feedback.m_appliedTorqueBodyA = btVector3(0, 0, 0);
  feedback.m_appliedForceBodyB = feedback.m_appliedTorqueBodyB = btVector3(0, 0, 0);
}

const btRigidBody& bodyOf(const btCollisionObject& object) { return *btRigidBody::upcast(&object); }

}  // namespace

void GroupRows::collect(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
                        std::span<btTypedConstraint* const> joints, const btContactSolverInfo& info) {
  dt_ = info.m_timeStep;
  errorReduction_ = info.m_erp;
  contactErrorReduction_ = info.m_erp2;
  softness_ = info.m_globalCfm / dt_;
  rows_.clear();
  ends_.clear();
  contacts_.clear();
  measured_.clear();
  takeBodies(bodies);
  isFriction_ = false;
  for (btTypedConstraint* joint : joints) addJoint(*joint);
  jointRows_ = static_cast<int>(rows_.size());
  for (btPersistentManifold* manifold : manifolds) addManifold(*manifold);
  unfrictionalRows_ = static_cast<int>(rows_.size());
  isFriction_ = true;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    addFrictionRows(contacts_[i], jointRows_ + static_cast<int>(i));
  }
  isFriction_ = false;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].torsion > 0) addTorsionRow(contacts_[i], jointRows_ + static_cast<int>(i));
  }
}

// each knows its number by its companion id; those that do not move have none
void GroupRows::takeBodies(std::span<btCollisionObject* const> bodies) {
  movers_.clear();
  for (btCollisionObject* object : bodies) {
    auto& body = static_cast<btRigidBody&>(*object);
    body.setCompanionId(static_cast<int>(movers_.size()));
    const btVector3 linear = body.getLinearVelocity() + body.getTotalForce() * (body.getInvMass() * dt_);
    const btVector3 angular = body.getAngularVelocity() + body.getInvInertiaTensorWorld() * body.getTotalTorque() * dt_;
    movers_.push_back({&body,
                       {linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()},
                       body.getAngularVelocity(),
                       {},
                       {},
                       -1});
  }
}

double GroupRows::addEnd(const btRigidBody& body, const btVector3& linear, const btVector3& angular) {
  if (body.getInvMass() == 0) return linear.dot(body.getLinearVelocity()) + angular.dot(body.getAngularVelocity());
  const int number = body.getCompanionId();
  Mover& mover = movers_[static_cast<std::size_t>(number)];
  const btVector3 linearResponse = linear * body.getInvMass();
  const btVector3 angularResponse = body.getInvInertiaTensorWorld() * angular;
  ends_.push_back({{linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()},
                   {linearResponse.x(), linearResponse.y(), linearResponse.z(), angularResponse.x(),
                    angularResponse.y(), angularResponse.z()},
                   static_cast<int>(rows_.size()) - 1,
                   number,
                   std::exchange(mover.lastEnd, static_cast<int>(ends_.size()))});
  if (!isFriction_) return dotOf(ends_.back().direction, mover.velocity);
  const auto& v = mover.velocity;
  return linear.dot(btVector3(v[0], v[1], v[2])) + angular.dot(mover.turnBefore);
}

void GroupRows::addJoint(btTypedConstraint& joint) {
  btTypedConstraint::btConstraintInfo1 size;
  joint.getInfo1(&size);
  std::array<JointRow, kMostRowsOfJoint> content;
  const auto count = static_cast<std::size_t>(size.m_numConstraintRows);
  for (std::size_t i = 0; i < count; ++i) content[i] = {{}, {}, {}, {}, 0, 0, -SIMD_INFINITY, SIMD_INFINITY};
  btTypedConstraint::btConstraintInfo2 info{};
  info.fps = 1 / dt_;
  info.erp = errorReduction_;
  info.m_J1linearAxis = content[0].linear1.data();
  info.m_J1angularAxis = content[0].angular1.data();
  info.m_J2linearAxis = content[0].linear2.data();
  info.m_J2angularAxis = content[0].angular2.data();
  info.rowskip = sizeof(JointRow) / sizeof(double);
  info.m_constraintError = &content[0].error;
  info.cfm = &content[0].softness;
  info.m_lowerLimit = &content[0].lowest;
  info.m_upperLimit = &content[0].highest;
  joint.getInfo2(&info);
  // what a gearbox does to a third body belongs to the row before it
  const bool isTail = isGearReference(joint);
  for (std::size_t i = 0; i < count; ++i) {
    const JointRow& each = content[i];
    if (!isTail) rows_.push_back({0, 0, bound(each.lowest), bound(each.highest)});
    const double along = addEnd(joint.getRigidBodyA(), vectorOf(each.linear1), vectorOf(each.angular1)) +
                         addEnd(joint.getRigidBodyB(), vectorOf(each.linear2), vectorOf(each.angular2));
    rows_.back().asked += each.error - along;
    if (joint.getJointFeedback() != nullptr) measured_.push_back({&joint, each, rows_.size() - 1});
  }
}

void GroupRows::addManifold(btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) addContact(manifold, manifold.getContactPoint(i));
}

void GroupRows::addContact(btPersistentManifold& manifold, btManifoldPoint& point) {
  const btRigidBody& a = bodyOf(*manifold.getBody0());
  const btRigidBody& b = bodyOf(*manifold.getBody1());
  Contact contact{&point,
                  &a,
                  &b,
                  point.getPositionWorldOnA() - a.getWorldTransform().getOrigin(),
                  point.getPositionWorldOnB() - b.getWorldTransform().getOrigin(),
                  point.m_combinedFriction,
                  0,
                  0,
                  0,
                  0};
  point.m_contactPointFlags &=
      ~(BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING | BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED);
  point.m_contactMotion1 = point.m_contactMotion2 = 0;
  if (const std::optional<PointSurface> surface = pointSurface(manifold, point)) {
    point.m_combinedRestitution = restitutionAt(manifold, point, *surface);
    if (surface->isSoft) {
      point.m_contactPointFlags |= BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING;
      point.m_combinedContactStiffness1 = surface->stiffness;
      point.m_combinedContactDamping1 = surface->damping;
    }
    contact.torsion = surface->torsion;
    contact.torsionSlip = surface->torsionSlip;
  }
  if (const std::optional<DirectedFriction> friction = directedFriction(manifold, point)) {
    point.m_combinedFriction = friction->mu;
    point.m_lateralFrictionDir1 = friction->direction;
    point.m_lateralFrictionDir2 = point.m_normalWorldOnB.cross(friction->direction);
    point.m_contactMotion1 = friction->motion1;
    point.m_contactMotion2 = friction->motion2;
    contact.mu2 = friction->mu2;
    contact.slip1 = friction->slip1;
    contact.slip2 = friction->slip2;
  } else {
    chooseDirections(contact);
  }
  contacts_.push_back(contact);
  addNormalRow(contact);
}

btVector3 GroupRows::velocityAt(const btRigidBody& body, const btVector3& arm) const {
  if (body.getInvMass() == 0) return body.getLinearVelocity() + body.getAngularVelocity().cross(arm);
  const auto& v = movers_[static_cast<std::size_t>(body.getCompanionId())].velocity;
  return btVector3(v[0], v[1], v[2]) + btVector3(v[3], v[4], v[5]).cross(arm);
}

// along the sliding, where there is one
void GroupRows::chooseDirections(const Contact& contact) const {
  btManifoldPoint& point = *contact.point;
  const btVector3& normal = point.m_normalWorldOnB;
  const btVector3 velocity = velocityAt(*contact.a, contact.armA) - velocityAt(*contact.b, contact.armB);
  const btVector3 sliding = velocity - normal * normal.dot(velocity);
  const double speed2 = sliding.length2();
  if (speed2 > SIMD_EPSILON) {
    point.m_lateralFrictionDir1 = sliding * (1 / std::sqrt(speed2));
    point.m_lateralFrictionDir2 = point.m_lateralFrictionDir1.cross(normal).normalize();
  } else {
    btPlaneSpace1(normal, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  }
}

void GroupRows::addNormalRow(const Contact& contact) {
  const btManifoldPoint& point = *contact.point;
  const btVector3& normal = point.m_normalWorldOnB;
  rows_.push_back({0, 0, 0, kNoBound});
  const double along =
      addEnd(*contact.a, normal, contact.armA.cross(normal)) + addEnd(*contact.b, -normal, -contact.armB.cross(normal));
  Row& row = rows_.back();
  row.asked = -along + bounceChange(point, contact.a, contact.b, dt_);
  if (point.m_combinedRestitution > 0) {
    const btVector3 velocity =
        contact.a->getVelocityInLocalPoint(contact.armA) - contact.b->getVelocityInLocalPoint(contact.armB);
    row.asked += std::max(0.0, -point.m_combinedRestitution * normal.dot(velocity));
  }
  const double distance = point.getDistance();
  if (distance > 0) row.asked -= distance / dt_;
  const double depth = std::max(0.0, -distance);
  if ((point.m_contactPointFlags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING) != 0) {
    // depth is a spring's, whose force gives speed
    const double stiffness = dt_ * point.m_combinedContactStiffness1;
    const double sum = std::max(stiffness + point.m_combinedContactDamping1, SIMD_EPSILON);
    row.asked += depth * (stiffness / sum) / dt_;
    row.give = 1 / sum / dt_;
  } else {
    // what is deep was put there: it is not to leap out
    row.askedApart = std::min(depth * contactErrorReduction_ / dt_, kFastestParting * dt_);
    row.isRigidContact = true;
  }
}

void GroupRows::addFrictionRows(const Contact& contact, int normal) {
  const btManifoldPoint& point = *contact.point;
  addFrictionRow(contact, point.m_lateralFrictionDir1, point.m_combinedFriction, contact.slip1, point.m_contactMotion1,
                 normal);
  addFrictionRow(contact, point.m_lateralFrictionDir2, contact.mu2, contact.slip2, point.m_contactMotion2, normal);
}

// slipping is a velocity in proportion to the force
void GroupRows::addFrictionRow(const Contact& contact, const btVector3& direction, double mu, double slip,
                               double motion, int normal) {
  rows_.push_back({0, 0, -mu, mu, slip / dt_, normal});
  const double along = addEnd(*contact.a, direction, contact.armA.cross(direction)) +
                       addEnd(*contact.b, -direction, -contact.armB.cross(direction));
  rows_.back().asked = motion - along;
}

void GroupRows::addTorsionRow(const Contact& contact, int normal) {
  const btVector3& axis = contact.point->m_normalWorldOnB;
  const btVector3 none(0, 0, 0);
  rows_.push_back({0, 0, -contact.torsion, contact.torsion, contact.torsionSlip / dt_, normal});
  const double along = addEnd(*contact.a, none, axis) + addEnd(*contact.b, none, -axis);
  rows_.back().asked = -along;
}

void GroupRows::couple(std::span<const int> places, double* A) {
  const std::size_t rows = rows_.size();
  std::fill_n(A, rows * rows, 0.0);
  const auto placeOf = [&](const End& end) {
    return static_cast<std::size_t>(places[static_cast<std::size_t>(end.row)]);
  };
  for (const End& end : ends_) {
    const std::size_t own = placeOf(end);
    A[own * rows + own] += dotOf(end.direction, end.response);
    for (int i = end.before; i >= 0; i = ends_[static_cast<std::size_t>(i)].before) {
      const End& each = ends_[static_cast<std::size_t>(i)];
      const std::size_t other = placeOf(each);
      const double sum = dotOf(each.direction, end.response);
      // two ends of one row at a body, as gearboxes have them, count both ways
      A[std::min(own, other) * rows + std::max(own, other)] += other == own ? 2 * sum : sum;
    }
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    double& own = A[place * rows + place];
    if (own <= kSmallestStiffness) rows_[i].asked = rows_[i].askedApart = 0;
    own += softness_ + rows_[i].give;
    if (rows_[i].isRigidContact) own *= 1 + kContactSoftness;
  }
}

void GroupRows::apply(std::span<const double> impulses, std::span<const double> apart) {
  for (const End& end : ends_) {
    Mover& mover = movers_[static_cast<std::size_t>(end.mover)];
    const auto row = static_cast<std::size_t>(end.row);
    for (std::size_t k = 0; k < 6; ++k) mover.change[k] += end.response[k] * impulses[row];
    if (row >= apart.size()) continue;
    for (std::size_t k = 0; k < 6; ++k) mover.push[k] += end.response[k] * apart[row];
  }
  for (const Mover& mover : movers_) {
    const auto& v = mover.velocity;
    const auto& d = mover.change;
    mover.body->setLinearVelocity({v[0] + d[0], v[1] + d[1], v[2] + d[2]});
    mover.body->setAngularVelocity({v[3] + d[3], v[4] + d[4], v[5] + d[5]});
    if (!apart.empty()) pushApart(mover);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    btManifoldPoint& point = *contacts_[i].point;
    const std::size_t friction = static_cast<std::size_t>(unfrictionalRows_) + 2 * i;
    point.m_appliedImpulse = impulses[static_cast<std::size_t>(jointRows_) + i];
    point.m_appliedImpulseLateral1 = impulses[friction];
    point.m_appliedImpulseLateral2 = impulses[friction + 1];
  }
  measure(impulses);
}

void GroupRows::pushApart(const Mover& mover) const {
  const auto& p = mover.push;
  const btVector3 linear = roundedVelocity(btVector3(p[0], p[1], p[2]));
  const btVector3 angular = roundedVelocity(btVector3(p[3], p[4], p[5])) * kTurnReduction;
  const btVector3 turn = angular * dt_;
  btTransform& X = mover.body->getWorldTransform();
  if (turn.length2() >= kSmallTurnApart * kSmallTurnApart) {
    X = moved(X, linear, angular, dt_);
    return;
  }
  X.setOrigin(X.getOrigin() + linear * dt_);
  // what is not quite a turn in it, the body's next turn of its own takes away (below 1e-6 until then)
  btMatrix3x3& R = X.getBasis();
  for (int column = 0; column < 3; ++column) {
    const btVector3 axis = R.getColumn(column);
    const btVector3 turned = axis + turn.cross(axis);
    for (int k = 0; k < 3; ++k) R[k][column] = turned[k];
  }
}

void GroupRows::measure(std::span<const double> impulses) const {
  for (const Measured& each : measured_) clear(*each.joint->getJointFeedback());
  for (const Measured& each : measured_) {
    btJointFeedback& feedback = *each.joint->getJointFeedback();
    const double force = impulses[each.row] / dt_;
    feedback.m_appliedForceBodyA += vectorOf(each.content.linear1) * force;
    feedback.m_appliedTorqueBodyA += vectorOf(each.content.angular1) * force;
    feedback.m_appliedForceBodyB += vectorOf(each.content.linear2) * force;
    feedback.m_appliedTorqueBodyB += vectorOf(each.content.angular2) * force;
  }
}

}  // namespace pongsim::physics
