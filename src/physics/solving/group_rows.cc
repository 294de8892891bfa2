#include "physics/solving/group_rows.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/contacts/contact_point.hh"
#include "physics/gearbox.hh"
#include "physics/motion.hh"
#include "physics/settings.hh"
#include "physics/solving/bounce.hh"
#include "physics/solving/rounding.hh"

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

void clear(btJointFeedback& feedback) {
  feedback.m_appliedForceBodyA = feedback.m_appliedTorqueBodyA = btVector3(0, 0, 0);
  feedback.m_appliedForceBodyB = feedback.m_appliedTorqueBodyB = btVector3(0, 0, 0);
}

const btRigidBody& bodyOf(const btCollisionObject& object) { return *btRigidBody::upcast(&object); }

/// @return The velocity along a row of a body that forces do not move.
double alongFixed(const btRigidBody& body, const std::array<double, 3>& linear, const std::array<double, 3>& angular) {
  return vectorOf(linear).dot(body.getLinearVelocity()) + vectorOf(angular).dot(body.getAngularVelocity());
}

/// @return Its number among the bodies of the group that move, -1 if it does not.
int numberOf(const btRigidBody& body) { return body.getInvMass() == 0 ? -1 : body.getCompanionId(); }

}  // namespace

std::span<const JointBodies> GroupRows::begin(std::span<btCollisionObject* const> bodies,
                                              std::span<btTypedConstraint* const> joints,
                                              const btContactSolverInfo& info) {
  dt_ = info.m_timeStep;
  errorReduction_ = info.m_erp;
  contactErrorReduction_ = info.m_erp2;
  softness_ = info.m_globalCfm / dt_;
  takeBodies(bodies);
  jointBodies_.clear();
  for (const btTypedConstraint* joint : joints) {
    // what a gearbox does to a third body belongs to the joint before it
    if (!isGearReference(*joint)) jointBodies_.push_back({-1, -1, -1});
    JointBodies& numbers = jointBodies_.back();
    for (const btRigidBody* body : {&joint->getRigidBodyA(), &joint->getRigidBodyB()}) {
      const int number = numberOf(*body);
      if (std::ranges::find(numbers, number) == numbers.end()) *std::ranges::find(numbers, -1) = number;
    }
  }
  return jointBodies_;
}

void GroupRows::collect(std::span<btPersistentManifold* const> manifolds, std::span<btTypedConstraint* const> joints,
                        bool isTree) {
  isTree_ = isTree;
  rows_.clear();
  endCount_ = 0;
  contacts_.clear();
  measured_.clear();
  isUsual_ = true;
  equations_.clear();
  if (isTree) blocks_.begin(movers_.size(), 2 * joints.size());
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
    const btMatrix3x3& I = body.getInvInertiaTensorWorld();
    const btVector3 angular = body.getAngularVelocity() + I * body.getTotalTorque() * dt_;
    movers_.push_back({&body,
                       {linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()},
                       body.getAngularVelocity(),
                       {},
                       {},
                       {Two{I[0].x(), I[1].x()}, Two{I[0].y(), I[1].y()}, Two{I[0].z(), I[1].z()}},
                       -1});
  }
}

double GroupRows::addEnd(const btRigidBody& body, const btVector3& linear, const btVector3& angular) {
  if (body.getInvMass() == 0) return linear.dot(body.getLinearVelocity()) + angular.dot(body.getAngularVelocity());
  const int number = body.getCompanionId();
  Mover& mover = movers_[static_cast<std::size_t>(number)];
  if (endCount_ == ends_.size()) ends_.resize(2 * endCount_ + 64);
  const int before = std::exchange(mover.lastEnd, static_cast<int>(endCount_));
  RowEnd& end = ends_[endCount_++];
  end.row = static_cast<int>(rows_.size()) - 1;
  end.body = number;
  end.before = before;
  Two* const direction = reinterpret_cast<Two*>(end.direction.data());
  const Two first{linear.x(), linear.y()}, middle{linear.z(), angular.x()}, last{angular.y(), angular.z()};
  direction[0] = first;
  direction[1] = middle;
  direction[2] = last;
  const double inverseMass = body.getInvMass();
  const Two* const I = mover.inverseMoments;
  const Two turn = I[0] * angular.x() + I[1] * angular.y() + I[2] * angular.z();
  const double lastTurn = body.getInvInertiaTensorWorld()[2].dot(angular);
  Two* const response = reinterpret_cast<Two*>(end.response.data());
  response[0] = first * inverseMass;
  response[1] = Two{linear.z() * inverseMass, turn[0]};
  response[2] = Two{turn[1], lastTurn};
  const auto& v = mover.velocity;
  if (!isFriction_) {
    const Two* const velocity = reinterpret_cast<const Two*>(v.data());
    const Two sums = first * velocity[0] + middle * velocity[1] + last * velocity[2];
    return sums[0] + sums[1];
  }
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
  isUsual_ = isUsual_ && !isTail && &joint.getRigidBodyA() != &joint.getRigidBodyB();
  if (isTree_) {
    addSideBySide(joint, std::span(content).first(count), isTail);
  } else {
    addOneByOne(joint, std::span(content).first(count), isTail);
  }
}

void GroupRows::addJointRow(const JointRow& content) {
  rows_.push_back({0, 0, bound(content.lowest), bound(content.highest)});
  rows_.back().isEquation = std::isinf(rows_.back().lowest) && std::isinf(rows_.back().highest);
}

void GroupRows::addOneByOne(btTypedConstraint& joint, std::span<const JointRow> content, bool isTail) {
  for (const JointRow& each : content) {
    if (!isTail) addJointRow(each);
    const double along = addEnd(joint.getRigidBodyA(), vectorOf(each.linear1), vectorOf(each.angular1)) +
                         addEnd(joint.getRigidBodyB(), vectorOf(each.linear2), vectorOf(each.angular2));
    rows_.back().asked += each.error - along;
    if (joint.getJointFeedback() != nullptr) measured_.push_back({&joint, each, rows_.size() - 1});
  }
}

/// Equations stand side by side, rows with bounds one by one.
void GroupRows::addSideBySide(btTypedConstraint& joint, std::span<const JointRow> content, bool isTail) {
  if (!isTail) equations_.push_back(0);
  const int number = static_cast<int>(equations_.size()) - 1;
  int& lanes = equations_.back();
  const std::size_t firstRow = isTail ? rows_.size() - 1 : rows_.size();
  const auto endAt = [&](const btRigidBody& body) {
    const int mover = numberOf(body);
    return mover < 0 ? nullptr : &blocks_.add(number, mover);
  };
  BlockRows::End* const a = endAt(joint.getRigidBodyA());
  BlockRows::End* const b = endAt(joint.getRigidBodyB());
  for (const JointRow& each : content) {
    if (!isTail) addJointRow(each);
    Row& row = rows_.back();
    if (joint.getJointFeedback() != nullptr) measured_.push_back({&joint, each, rows_.size() - 1});
    row.asked += each.error;
    if (!row.isEquation) {
      row.asked -= addEnd(joint.getRigidBodyA(), vectorOf(each.linear1), vectorOf(each.angular1)) +
                   addEnd(joint.getRigidBodyB(), vectorOf(each.linear2), vectorOf(each.angular2));
      continue;
    }
    row.joint = number;
    if (!isTail) row.lane = lanes++;
    // a joint with more is refused later
    const auto lane = std::min(static_cast<std::size_t>(row.lane), BlockRows::kLanes - 1);
    if (a != nullptr) BlockRows::set(*a, lane, each.linear1, each.angular1);
    if (b != nullptr) BlockRows::set(*b, lane, each.linear2, each.angular2);
    if (a == nullptr) row.asked -= alongFixed(joint.getRigidBodyA(), each.linear1, each.angular1);
    if (b == nullptr) row.asked -= alongFixed(joint.getRigidBodyB(), each.linear2, each.angular2);
  }
  for (BlockRows::End* const end : {a, b}) {
    if (end == nullptr) continue;
    const BlockRows::Lanes along = respond(*end);
    for (Row& row : std::span(rows_).subspan(firstRow)) {
      if (row.joint == number) row.asked -= along[static_cast<std::size_t>(row.lane) % BlockRows::kLanes];
    }
  }
}

BlockRows::Lanes GroupRows::respond(BlockRows::End& end) const {
  const Mover& mover = movers_[static_cast<std::size_t>(end.body)];
  const btMatrix3x3& I = mover.body->getInvInertiaTensorWorld();
  return BlockRows::respond(
      end,
      {mover.body->getInvMass(),
       {I[0].x(), I[0].y(), I[0].z(), I[1].x(), I[1].y(), I[1].z(), I[2].x(), I[2].y(), I[2].z()}},
      mover.velocity);
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
  point.m_contactMotion1 = point.m_contactMotion2 = 0;
  const PointFriction found = settlePoint(point, manifold);
  contact.torsion = found.torsion;
  contact.torsionSlip = found.torsionSlip;
  if (found.isDirected) {
    contact.mu2 = found.mu2;
    contact.slip1 = found.slip1;
    contact.slip2 = found.slip2;
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

void GroupRows::couple(std::span<const int> places, const UpperRows& A) {
  for (RowEnd& end : ends()) end.place = places[static_cast<std::size_t>(end.row)];
  if (isUsual_) {
    for (const Mover& mover : movers_) bodyCoupling_.couple(ends(), mover.lastEnd, A);
  } else {
    for (const RowEnd& end : ends()) coupleBefore(ends(), end, A);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    soften(rows_[i], A.row(place)[place]);
  }
}

void GroupRows::couple(const JointOrder& order, std::span<const int> numbers, BlockMatrix& A) {
  blocks_.couple(order, equations_, A);
  const UpperRows bounded = A.bounded();
  for (RowEnd& end : ends()) {
    end.place = numbers[static_cast<std::size_t>(end.row)];
    blocks_.couple(order, equations_, end.body, end.response, end.place, A);
    coupleBefore(ends(), end, bounded);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    const int place = row.isEquation ? order.placeOf(row.joint) : A.boundedPlace();
    const int number = row.isEquation ? row.lane : numbers[i];
    const BlockMatrix::Part part = A.part(place, place);
    soften(row, part.data[static_cast<std::size_t>(number) * (part.stride + 1)]);
  }
}

void GroupRows::soften(Row& row, double& own) const {
  if (own <= kSmallestStiffness) row.asked = row.askedApart = 0;
  own += softness_ + row.give;
  if (row.isRigidContact) own *= 1 + kContactSoftness;
}

void GroupRows::listBoundedEnds(std::span<const int> numbers, std::vector<BlockMatrix::BoundedEnd>& list) const {
  list.clear();
  for (std::size_t i = 0; i < endCount_; ++i) {
    list.push_back({numbers[static_cast<std::size_t>(ends_[i].row)], ends_[i].body});
  }
}

void GroupRows::applyEquations(const JointOrder& order, const BlockMatrix& A, const double* x, const double* apart) {
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const int body = static_cast<int>(i);
    blocks_.apply(body, order, A, x, movers_[i].change);
    if (apart != nullptr) blocks_.apply(body, order, A, apart, movers_[i].push);
  }
}

void GroupRows::apply(std::span<const double> impulses, std::span<const double> apart) {
  for (const RowEnd& end : ends()) {
    Mover& mover = movers_[static_cast<std::size_t>(end.body)];
    const auto row = static_cast<std::size_t>(end.row);
    addTimes(mover.change, end.response, impulses[row]);
    if (row < apart.size()) addTimes(mover.push, end.response, apart[row]);
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
