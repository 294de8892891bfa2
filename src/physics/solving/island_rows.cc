#include "physics/solving/island_rows.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "physics/contacts/bounce.hh"
#include "physics/motion.hh"
#include "physics/rounding.hh"

namespace pongsim::physics {

namespace {

// Compliance of rigid contacts, as a fraction of the inverse mass that they move. A body on more than three points,
// such as a robot on two wheels and two casters, then spreads its weight over all of them. With rigid points, a
// difference of nanometres would lift the wheels off the ground, and they would spin.
constexpr double kContactCompliance = 1e-4;

// a larger change of velocity comes from an inertia that is not invertible in floating-point numbers [m/s, rad/s]
constexpr double kLargestChange = 1e6;

// J M^-1 J^T below which a row moves nothing, because that is rounding [1/kg]
constexpr double kSmallestInverseMass = SIMD_EPSILON;

// Fraction of the rotation by push impulses that is applied (Bullet's m_splitImpulseTurnErp).
constexpr double kPushRotationErp = 0.1;

// a push rotation below this is applied to first order [rad]
constexpr double kSmallPushRotation = 1e-4;

/// J of a body of a joint: its parent, its child or, of a gearbox, its reference body.
struct BodyJacobian {
  btVector3 linear;
  btVector3 angular;
};

constexpr std::size_t kMostJointBodies = 3;

BodyJacobian jacobianOf(const JointRow& row, std::size_t body) {
  if (body == 0) return {-row.linear, row.parentAngular};
  if (body == 1) return {row.linear, row.childAngular};
  return {btVector3(0, 0, 0), row.referenceAngular};
}

}  // namespace

std::span<const JointBodies> IslandRows::begin(std::span<btRigidBody* const> bodies, std::span<Joint* const> joints,
                                               double dt) {
  dt_ = dt;
  takeBodies(bodies);
  jointBodies_.clear();
  for (const Joint* joint : joints) {
    const btRigidBody* const reference = joint->reference();
    jointBodies_.push_back({numberOf(joint->parent()), numberOf(joint->child()),
                            reference == nullptr ? -1 : numberOf(*reference), !joint->isGearbox()});
  }
  return jointBodies_;
}

void IslandRows::collect(std::span<btPersistentManifold* const> manifolds, std::span<Joint* const> joints,
                         const JointTree* tree) {
  tree_ = tree;
  rows_.clear();
  endCount_ = 0;
  contacts_.clear();
  measured_.clear();
  measuredLinks_.clear();
  areOfTwoBodies_ = true;
  isFriction_ = false;
  if (tree == nullptr) {
    for (Joint* joint : joints) addJoint(*joint);
  } else {
    articulation_.begin(*tree, bodies_.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (tree->linkOfJoint(i) < 0) addJoint(*joints[i]);
    }
    closingRows_ = rows_.size();
    for (const JointTree::Link& link : tree->links()) addLink(*joints[static_cast<std::size_t>(link.joint)], link);
  }
  jointRows_ = static_cast<int>(rows_.size());
  for (btPersistentManifold* manifold : manifolds) {
    for (int i = 0; i < manifold->getNumContacts(); ++i) {
      addContact(contacts_.emplace_back(manifold->getContactPoint(i), *manifold));
    }
  }
  unfrictionalRows_ = static_cast<int>(rows_.size());
  isFriction_ = true;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const SolverContact& contact = contacts_[i];
    const btManifoldPoint& point = contact.point;
    const int normal = jointRows_ + static_cast<int>(i);
    addFrictionRow(contact, point.m_lateralFrictionDir1, point.m_combinedFriction, contact.friction.slip1,
                   point.m_contactMotion1, normal);
    addFrictionRow(contact, point.m_lateralFrictionDir2, contact.friction.mu2, contact.friction.slip2,
                   point.m_contactMotion2, normal);
  }
  isFriction_ = false;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].friction.torsion > 0) addTorsionRow(contacts_[i], jointRows_ + static_cast<int>(i));
  }
}

/// @return Its number in the island, -1 for a body that does not move.
int IslandRows::numberOf(const btRigidBody& body) const {
  if (body.getInvMass() == 0) return -1;
  const int number = body.getCompanionId();
  assert(number >= 0 && static_cast<std::size_t>(number) < bodies_.size());
  assert(bodies_[static_cast<std::size_t>(number)].body == &body);
  return number;
}

// a body's companion id is its number in the island
void IslandRows::takeBodies(std::span<btRigidBody* const> bodies) {
  bodies_.clear();
  for (btRigidBody* each : bodies) {
    btRigidBody& body = *each;
    assert(body.getInvMass() > 0 && std::isfinite(body.getInvMass()));
    body.setCompanionId(static_cast<int>(bodies_.size()));
    const btVector3 linear = body.getLinearVelocity() + body.getTotalForce() * (body.getInvMass() * dt_);
    const btMatrix3x3& I = body.getInvInertiaTensorWorld();
    const btVector3 angular = body.getAngularVelocity() + I * body.getTotalTorque() * dt_;
    Body& own = bodies_.emplace_back();
    own.body = &body;
    own.velocity = {linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()};
    own.angularBefore = body.getAngularVelocity();
    for (int k = 0; k < 3; ++k) own.inverseMoments[k] = Two{I[0][k], I[1][k]};
    own.inertia = spatialInertiaOf(body);
    if (own.inertia != nullptr) own.velocity = velocityUnderForces(own);
  }
}

/// @return The velocity of a body with a spatial inertia, with the external forces of this step.
std::array<double, 6> IslandRows::velocityUnderForces(const Body& body) const {
  const btRigidBody& rigid = *body.body;
  const btVector3 &v = rigid.getLinearVelocity(), &w = rigid.getAngularVelocity();
  std::array<double, 6> velocity{v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
  addTimes(velocity, body.inertia->respond(rigid.getTotalForce(), rigid.getTotalTorque()), dt_);
  return velocity;
}

/// Adds an end of the last row.
/// @return The velocity of the body along the row.
double IslandRows::addEnd(const btRigidBody& body, const btVector3& linear, const btVector3& angular) {
  if (body.getInvMass() == 0) return linear.dot(body.getLinearVelocity()) + angular.dot(body.getAngularVelocity());
  const int number = numberOf(body);
  Body& own = bodies_[static_cast<std::size_t>(number)];
  if (endCount_ == ends_.size()) ends_.resize(2 * endCount_ + 64);
  const int before = std::exchange(own.lastEnd, static_cast<int>(endCount_));
  RowEnd& end = ends_[endCount_++];
  end.row = static_cast<int>(rows_.size()) - 1;
  end.body = number;
  end.before = before;
  Two* const jacobian = reinterpret_cast<Two*>(end.jacobian.data());
  const Two first{linear.x(), linear.y()}, middle{linear.z(), angular.x()}, last{angular.y(), angular.z()};
  jacobian[0] = first;
  jacobian[1] = middle;
  jacobian[2] = last;
  const double inverseMass = body.getInvMass();
  const Two* const I = own.inverseMoments;
  const Two turn = I[0] * angular.x() + I[1] * angular.y() + I[2] * angular.z();
  const double lastTurn = body.getInvInertiaTensorWorld()[2].dot(angular);
  Two* const response = reinterpret_cast<Two*>(end.response.data());
  response[0] = first * inverseMass;
  response[1] = Two{linear.z() * inverseMass, turn[0]};
  response[2] = Two{turn[1], lastTurn};
  if (own.inertia != nullptr) end.response = own.inertia->respond(linear, angular);
  const auto& v = own.velocity;
  if (!isFriction_) {
    const Two* const velocity = reinterpret_cast<const Two*>(v.data());
    const Two sums = first * velocity[0] + middle * velocity[1] + last * velocity[2];
    return sums[0] + sums[1];
  }
  return linear.dot(btVector3(v[0], v[1], v[2])) + angular.dot(own.angularBefore);
}

/// Adds the ends of the last row, which is a joint's.
/// @return The velocity of the joint's bodies along it.
double IslandRows::addJointEnds(const Joint& joint, const JointRow& content) {
  const auto at = [&](const btRigidBody& body, std::size_t number) {
    const BodyJacobian J = jacobianOf(content, number);
    return addEnd(body, J.linear, J.angular);
  };
  const double along = at(joint.parent(), 0) + at(joint.child(), 1);
  return joint.reference() == nullptr ? along : along + at(*joint.reference(), 2);
}

void IslandRows::addJoint(Joint& joint) {
  std::array<JointRow, Joint::kMostRows> memory;
  areOfTwoBodies_ = areOfTwoBodies_ && joint.reference() == nullptr && &joint.parent() != &joint.child();
  for (const JointRow& each : joint.rows(dt_, settings_.jointErp, memory)) {
    addJointRow(joint, each);
    if (joint.isMeasured()) measured_.push_back({&joint, each, rows_.size() - 1});
  }
}

void IslandRows::addJointRow(const Joint& joint, const JointRow& content) {
  Row& row = rows_.emplace_back(Row{content.bias, 0, content.lowest, content.highest});
  row.isEquation = std::isinf(content.lowest) && std::isinf(content.highest);
  row.compliance = content.compliance;
  row.rhs -= addJointEnds(joint, content);
}

void IslandRows::addLink(Joint& joint, const JointTree::Link& link) {
  std::array<JointRow, Joint::kMostRows> memory;
  JointMotion motion;
  for (const JointRow& each : joint.motion(dt_, settings_.jointErp, motion, memory)) addJointRow(joint, each);
  const auto velocityOf = [this](const btRigidBody& body) {
    const int number = numberOf(body);
    if (number < 0) return std::pair(body.getLinearVelocity(), body.getAngularVelocity());
    const auto& v = bodies_[static_cast<std::size_t>(number)].velocity;
    return std::pair(btVector3(v[0], v[1], v[2]), btVector3(v[3], v[4], v[5]));
  };
  const auto [v_Parent, w_Parent] = velocityOf(joint.parent());
  const auto [v_Child, w_Child] = velocityOf(joint.child());
  articulation_.add(link, motion,
                    v_Child + w_Child.cross(motion.childArm) - v_Parent - w_Parent.cross(motion.parentArm),
                    w_Child - w_Parent);
  if (joint.isMeasured()) measuredLinks_.emplace_back(&joint, &link);
}

/// Writes the inertia with which a body responds to impulses.
void IslandRows::takeInertia(const Body& body, Articulation::Inertia& inertia) const {
  if (body.inertia != nullptr) {
    const SpatialInertia::Matrix ahead = body.inertia->ahead();
    for (std::size_t i = 0; i < inertia.size(); ++i)
      std::copy_n(ahead.col(static_cast<int>(i)).data(), 6, inertia[i].begin());
    return;
  }
  for (Articulation::Vector& row : inertia) row.fill(0);
  inertia[0][0] = inertia[1][1] = inertia[2][2] = body.body->getMass();
  // the inverse of a symmetric matrix, by its cofactors
  const btMatrix3x3& I = body.body->getInvInertiaTensorWorld();
  const double a = I[0].x(), b = I[0].y(), c = I[0].z(), d = I[1].y(), e = I[1].z(), f = I[2].z();
  const double A = d * f - e * e, B = c * e - b * f, C = b * e - c * d;
  const double factor = 1 / (a * A + b * B + c * C);
  inertia[3][3] = factor * A;
  inertia[3][4] = inertia[4][3] = factor * B;
  inertia[3][5] = inertia[5][3] = factor * C;
  inertia[4][4] = factor * (a * f - c * c);
  inertia[4][5] = inertia[5][4] = factor * (b * c - a * e);
  inertia[5][5] = factor * (a * d - b * b);
}

/// Finds how the bodies move as their joints ask for, and from now on rows see that motion.
bool IslandRows::articulate() {
  if (tree_ == nullptr) return true;
  for (std::size_t i = 0; i < bodies_.size(); ++i) takeInertia(bodies_[i], articulation_.inertia(i));
  if (!articulation_.factor()) return false;
  const std::span<const Articulation::Vector> changes = articulation_.changeByJoints();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (const double each : changes[i]) {
      if (!(std::abs(each) < kLargestChange)) return false;
    }
    std::copy_n(changes[i].begin(), 6, bodies_[i].change.begin());
  }
  resolveRows();
  return true;
}

void IslandRows::resolveRows() {
  const std::size_t width = articulation_.coordinates();
  Z_.assign(rows_.size() * width, 0.0);
  ownDiagonal_.assign(rows_.size(), 0.0);
  std::array<Articulation::End, kMostJointBodies> ofRow;
  for (std::size_t first = 0, end = 0; first < endCount_; first = end) {
    const auto row = static_cast<std::size_t>(ends_[first].row);
    for (; end < endCount_ && ends_[end].row == ends_[first].row; ++end) {
      const RowEnd& each = ends_[end];
      ofRow[end - first] = {each.body, each.jacobian.data()};
      ownDiagonal_[row] += coupling(each, each);
      const auto& change = bodies_[static_cast<std::size_t>(each.body)].change;
      for (std::size_t k = 0; k < change.size(); ++k) rows_[row].rhs -= each.jacobian[k] * change[k];
    }
    articulation_.resolve(std::span(ofRow).first(end - first), &Z_[row * width]);
  }
}

btVector3 IslandRows::velocityAt(const btRigidBody& body, const btVector3& arm) const {
  const int number = numberOf(body);
  if (number < 0) return body.getLinearVelocity() + body.getAngularVelocity().cross(arm);
  const auto& v = bodies_[static_cast<std::size_t>(number)].velocity;
  return btVector3(v[0], v[1], v[2]) + btVector3(v[3], v[4], v[5]).cross(arm);
}

void IslandRows::addContact(const SolverContact& contact) {
  if (!contact.friction.isDirected) {
    contact.chooseDirections(velocityAt(contact.a, contact.armA) - velocityAt(contact.b, contact.armB));
  }
  const btManifoldPoint& point = contact.point;
  const btVector3& normal = point.m_normalWorldOnB;
  rows_.push_back({0, 0, 0, kInfinity});
  const double along =
      addEnd(contact.a, normal, contact.armA.cross(normal)) + addEnd(contact.b, -normal, -contact.armB.cross(normal));
  Row& row = rows_.back();
  row.rhs = -along + bounceChange(point, contact.a, contact.b, dt_);
  if (point.m_combinedRestitution > 0) {
    const btVector3 velocity =
        contact.a.getVelocityInLocalPoint(contact.armA) - contact.b.getVelocityInLocalPoint(contact.armB);
    row.rhs += std::max(0.0, -point.m_combinedRestitution * normal.dot(velocity));
  }
  const double distance = point.getDistance();
  if (distance > 0) row.rhs -= distance / dt_;
  const double depth = std::max(0.0, -distance);
  // deep overlap comes from placing, not from motion, so it is pushed out at a limited speed
  row.pushRhs = std::min(depth * settings_.contactErp / dt_, kMaxPushAcceleration * dt_);
  row.isContact = true;
}

// slip is a velocity proportional to the force: a compliance of slip / dt
void IslandRows::addFrictionRow(const SolverContact& contact, const btVector3& direction, double mu, double slip,
                                double motion, int normal) {
  rows_.push_back({0, 0, -mu, mu, slip / dt_, normal});
  const double along = addEnd(contact.a, direction, contact.armA.cross(direction)) +
                       addEnd(contact.b, -direction, -contact.armB.cross(direction));
  rows_.back().rhs = motion - along;
}

void IslandRows::addTorsionRow(const SolverContact& contact, int normal) {
  const btVector3& axis = contact.point.m_normalWorldOnB;
  const btVector3 none(0, 0, 0);
  const PointFriction& friction = contact.friction;
  rows_.push_back({0, 0, -friction.torsion, friction.torsion, friction.torsionSlip / dt_, normal});
  const double along = addEnd(contact.a, none, axis) + addEnd(contact.b, none, -axis);
  rows_.back().rhs = -along;
}

void IslandRows::assemble(std::span<const int> places, const UpperRows& A) {
  assert(places.size() == rows_.size() && A.rows == rows_.size());
  if (tree_ != nullptr) {
    addSquare(Z_.data(), articulation_.coordinates(), places, A);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto place = static_cast<std::size_t>(places[i]);
      double regular = ownDiagonal_[i];
      regularize(rows_[i], regular);
      A.row(place)[place] += regular - ownDiagonal_[i];
    }
    return;
  }
  for (RowEnd& end : ends()) end.place = places[static_cast<std::size_t>(end.row)];
  if (areOfTwoBodies_) {
    for (const Body& body : bodies_) bodyCoupling_.couple(ends(), body.lastEnd, A);
  } else {
    for (const RowEnd& end : ends()) coupleBefore(ends(), end, A);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    regularize(rows_[i], A.row(place)[place]);
  }
}

/// Adds the compliance of a row to its place on the diagonal of A.
void IslandRows::regularize(Row& row, double& diagonal) const {
  assert(diagonal >= 0);
  if (diagonal <= kSmallestInverseMass) row.rhs = row.pushRhs = 0;
  diagonal += settings_.cfm / dt_ + row.compliance;
  if (row.isContact) diagonal *= 1 + kContactCompliance;
}

/// Adds what the impulses of rows do to all bodies of the trees.
void IslandRows::applyToTree(std::span<const double> impulses, std::array<double, 6> Body::*to) {
  const std::size_t width = articulation_.coordinates();
  z_.assign(width, 0.0);
  for (std::size_t row = 0; row < impulses.size(); ++row) {
    for (std::size_t k = 0; k < width; ++k) z_[k] += Z_[row * width + k] * impulses[row];
  }
  const std::span<const Articulation::Vector> changes = articulation_.changeBy(z_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) (bodies_[i].*to)[k] += changes[i][k];
  }
}

void IslandRows::apply(std::span<const double> impulses, std::span<const double> pushes) {
  if (tree_ != nullptr) {
    if (!impulses.empty()) applyToTree(impulses, &Body::change);
    if (!pushes.empty()) applyToTree(pushes, &Body::push);
  } else {
    for (const RowEnd& end : ends()) {
      Body& body = bodies_[static_cast<std::size_t>(end.body)];
      const auto row = static_cast<std::size_t>(end.row);
      addTimes(body.change, end.response, impulses[row]);
      if (row < pushes.size()) addTimes(body.push, end.response, pushes[row]);
    }
  }
  for (const Body& body : bodies_) {
    const auto& v = body.velocity;
    const auto& d = body.change;
    body.body->setLinearVelocity({v[0] + d[0], v[1] + d[1], v[2] + d[2]});
    body.body->setAngularVelocity({v[3] + d[3], v[4] + d[4], v[5] + d[5]});
    if (!pushes.empty()) applyPush(body);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    btManifoldPoint& point = contacts_[i].point;
    const std::size_t friction = static_cast<std::size_t>(unfrictionalRows_) + 2 * i;
    point.m_appliedImpulse = impulses[static_cast<std::size_t>(jointRows_) + i];
    point.m_appliedImpulseLateral1 = impulses[friction];
    point.m_appliedImpulseLateral2 = impulses[friction + 1];
  }
  measure(impulses);
  if (!measuredLinks_.empty()) measureLinks(impulses);
}

/// Moves the body by its push velocity over the step.
void IslandRows::applyPush(const Body& body) const {
  const auto& p = body.push;
  const btVector3 linear = roundedVelocity(btVector3(p[0], p[1], p[2]));
  const btVector3 angular = roundedVelocity(btVector3(p[3], p[4], p[5])) * kPushRotationErp;
  const btVector3 turn = angular * dt_;
  btTransform& X = body.body->getWorldTransform();
  if (turn.length2() >= kSmallPushRotation * kSmallPushRotation) {
    X = moved(X, linear, angular, dt_);
    return;
  }
  X.setOrigin(X.getOrigin() + linear * dt_);
  // R += [turn] R, to first order: R is a rotation but for 1e-6, and the next integration normalizes it
  btMatrix3x3& R = X.getBasis();
  for (int column = 0; column < 3; ++column) {
    const btVector3 axis = R.getColumn(column);
    const btVector3 turned = axis + turn.cross(axis);
    for (int k = 0; k < 3; ++k) R[k][column] = turned[k];
  }
}

/// Tells measured joints the sum of their rows' forces, J^T x / dt, on the child.
void IslandRows::measure(std::span<const double> impulses) const {
  for (std::size_t i = 0; i < measured_.size();) {
    Joint& joint = *measured_[i].joint;
    btVector3 force(0, 0, 0), torque(0, 0, 0);
    for (; i < measured_.size() && measured_[i].joint == &joint; ++i) {
      const double rowForce = impulses[measured_[i].row] / dt_;
      force += measured_[i].content.linear * rowForce;
      torque += measured_[i].content.childAngular * rowForce;
    }
    joint.setReaction(force, torque);
  }
}

/// Likewise of joints that hold links: what moved the body and all links beyond it, less what others than joints did.
void IslandRows::measureLinks(std::span<const double> impulses) {
  wrenches_.assign(bodies_.size(), {});
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Articulation::Inertia inertia{};
    takeInertia(bodies_[i], inertia);
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t row = 0; row < 6; ++row) wrenches_[i][row] += inertia[row][k] * bodies_[i].change[k];
    }
  }
  for (std::size_t i = 0; i < endCount_; ++i) {
    const RowEnd& end = ends_[i];
    const auto row = static_cast<std::size_t>(end.row);
    if (row >= closingRows_ && end.row < jointRows_) continue;
    for (std::size_t k = 0; k < 6; ++k) {
      wrenches_[static_cast<std::size_t>(end.body)][k] -= end.jacobian[k] * impulses[row];
    }
  }
  articulation_.gather(wrenches_);
  for (const auto& [joint, link] : measuredLinks_) {
    const auto& wrench = wrenches_[static_cast<std::size_t>(link->body)];
    btVector3 force(wrench[0], wrench[1], wrench[2]), torque(wrench[3], wrench[4], wrench[5]);
    if (link->isReversed) {
      const btVector3 toChild =
          joint->child().getWorldTransform().getOrigin() - joint->parent().getWorldTransform().getOrigin();
      torque = -(torque - toChild.cross(force));
      force = -force;
    }
    joint->setReaction(force / dt_, torque / dt_);
  }
}

}  // namespace pongsim::physics
