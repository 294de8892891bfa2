#include "physics/solving/gauss_seidel.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "physics/contacts/bounce.hh"

namespace pongsim::physics {

namespace {

/// Fraction of a contact's last impulse that it starts with.
constexpr double kWarmStart = 0.85;

// J M^-1 J^T below which a joint's row moves nothing [1/kg]
constexpr double kLeastInverseMass = SIMD_EPSILON;

}  // namespace

void GaussSeidel::solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
                        std::span<Joint* const> joints, double dt) {
  dt_ = dt;
  takeBodies(bodies);
  jointRows_.clear();
  thirdBodies_.clear();
  measured_.clear();
  for (Joint* joint : joints) addJoint(*joint);
  normals_.clear();
  frictions_.clear();
  torsions_.clear();
  points_.clear();
  for (btPersistentManifold* manifold : manifolds) {
    for (int i = 0; i < manifold->getNumContacts(); ++i) addContact({manifold->getContactPoint(i), *manifold});
  }
  for (int i = 0; i < settings_.iterations && sweep(); ++i) {
  }
  writeBack();
}

void GaussSeidel::takeBodies(std::span<btRigidBody* const> bodies) {
  const btVector3 none(0, 0, 0);
  bodies_.assign(1, {nullptr, 0, none, none, none, none});
  isGeneral_ = false;
  for (btRigidBody* body : bodies) {
    assert(body->getInvMass() > 0 && std::isfinite(body->getInvMass()));
    body->setCompanionId(static_cast<int>(bodies_.size()));
    bodies_.push_back({body, body->getInvMass(), body->getTotalForce() * body->getInvMass() * dt_,
                       body->getTotalTorque() * body->getInvInertiaTensorWorld() * dt_, none, none});
    Body& own = bodies_.back();
    own.inertia = spatialInertiaOf(*body);
    if (own.inertia == nullptr) continue;
    isGeneral_ = true;
    const Motion change = responseOf(bodies_.size() - 1, body->getTotalForce() * dt_, body->getTotalTorque() * dt_);
    own.forceChange = change.linear;
    own.torqueChange = change.angular;
  }
}

/// @return M^-1 J^T, of any body.
GaussSeidel::Motion GaussSeidel::responseOf(std::size_t number, const btVector3& linear,
                                            const btVector3& angular) const {
  const Body& body = bodies_[number];
  if (body.body == nullptr) return {btVector3(0, 0, 0), btVector3(0, 0, 0)};
  if (body.inertia == nullptr) {
    return {linear * body.inverseMass, body.body->getInvInertiaTensorWorld() * angular};
  }
  const SpatialInertia::Motion d = body.inertia->respond(linear, angular);
  return {{d[0], d[1], d[2]}, {d[3], d[4], d[5]}};
}

/// @return J M^-1 J^T, whatever bodies there are.
double GaussSeidel::inverseMassOf(const Row& row) const {
  const Motion a = responseOf(row.a, row.linear, row.angularA.jacobian);
  const Motion b = responseOf(row.b, -row.linear, row.angularB.jacobian);
  return row.linear.dot(a.linear - b.linear) + row.angularA.jacobian.dot(a.angular) +
         row.angularB.jacobian.dot(b.angular);
}

void GaussSeidel::applyGenerally(std::size_t number, const btVector3& linear, const btVector3& angular,
                                 double impulse) {
  const Motion change = responseOf(number, linear, angular);
  bodies_[number].linearChange += change.linear * impulse;
  bodies_[number].angularChange += change.angular * impulse;
}

std::size_t GaussSeidel::numberOf(const btRigidBody& body) const {
  if (body.getInvMass() == 0) return 0;
  const auto number = static_cast<std::size_t>(body.getCompanionId());
  assert(number < bodies_.size() && bodies_[number].body == &body);
  return number;
}

void GaussSeidel::addJoint(Joint& joint) {
  const btRigidBody &parent = joint.parent(), &child = joint.child();
  const btRigidBody* const reference = joint.reference();
  if (joint.isMeasured()) measured_.push_back({&joint, jointRows_.size()});
  std::array<JointRow, Joint::kMostRows> memory;
  const std::span<const JointRow> rows = joint.rows(dt_, settings_.jointErp, memory);
  for (const JointRow& content : rows) {
    const auto angular = [](const btRigidBody& body, const btVector3& jacobian) {
      return Angular{jacobian, body.getInvInertiaTensorWorld() * jacobian};
    };
    Row row{numberOf(parent), numberOf(child), -content.linear, angular(parent, content.parentAngular),
            angular(child, content.childAngular)};
    double inverseMass = (row.linear * parent.getInvMass()).dot(row.linear);
    inverseMass += row.angularA.response.dot(row.angularA.jacobian);
    inverseMass += (row.linear * child.getInvMass()).dot(row.linear);
    inverseMass += row.angularB.response.dot(row.angularB.jacobian);
    if (isGeneral_) inverseMass = inverseMassOf(row);
    double velocity = velocityAlong(row, true);
    if (reference != nullptr) {
      const ThirdBody third{jointRows_.size(), numberOf(*reference), angular(*reference, content.referenceAngular)};
      inverseMass += third.angular.jacobian.dot(
          isGeneral_ ? responseOf(third.body, btVector3(0, 0, 0), third.angular.jacobian).angular
                     : third.angular.response);
      velocity += third.angular.jacobian.dot(reference->getAngularVelocity() + bodies_[third.body].torqueChange);
      thirdBodies_.push_back(third);
    }
    row.effectiveMass = std::abs(inverseMass) > kLeastInverseMass ? 1 / (inverseMass + content.compliance) : 0;
    row.rhs = content.bias * row.effectiveMass + -velocity * row.effectiveMass;
    // only of the first row, as in Bullet
    row.cfm = (&content == rows.data() ? settings_.cfm : 0) + content.compliance * row.effectiveMass;
    row.lowest = content.lowest;
    row.highest = content.highest;
    jointRows_.push_back(row);
  }
}

double GaussSeidel::velocityAlong(const Row& row, bool withTorques) const {
  const auto along = [&](std::size_t number, const btVector3& linear, const btVector3& angular) {
    const Body& body = bodies_[number];
    if (body.body == nullptr) return 0.0;
    const btVector3 w = body.body->getAngularVelocity();
    return linear.dot(body.body->getLinearVelocity() + body.forceChange) +
           angular.dot(withTorques ? w + body.torqueChange : w);
  };
  return along(row.a, row.linear, row.angularA.jacobian) + along(row.b, -row.linear, row.angularB.jacobian);
}

/// @return A row for the relative velocity along a direction at the contact point, without right-hand side.
GaussSeidel::Row GaussSeidel::makeRow(const SolverContact& contact, const btVector3& direction,
                                      double compliance) const {
  const btVector3 none(0, 0, 0);
  Row row{numberOf(contact.a), numberOf(contact.b), direction, {none, none}, {none, none}};
  double inverseMassA = 0, inverseMassB = 0;
  if (row.a != 0) {
    const btVector3 jacobian = contact.armA.cross(direction);
    row.angularA = {jacobian, contact.a.getInvInertiaTensorWorld() * jacobian};
    inverseMassA = contact.a.getInvMass() + direction.dot(row.angularA.response.cross(contact.armA));
  }
  if (row.b != 0) {
    const btVector3 jacobian = -contact.armB.cross(direction);
    row.angularB = {jacobian, contact.b.getInvInertiaTensorWorld() * jacobian};
    inverseMassB = contact.b.getInvMass() + direction.dot((-row.angularB.response).cross(contact.armB));
  }
  row.effectiveMass = 1 / ((isGeneral_ ? inverseMassOf(row) : inverseMassA + inverseMassB) + compliance);
  return row;
}

void GaussSeidel::addContact(const SolverContact& contact) {
  btManifoldPoint& point = contact.point;
  const btVector3& normal = point.m_normalWorldOnB;
  const double rate = 1 / dt_;
  const double cfm = settings_.cfm * rate;
  Row row = makeRow(contact, normal, cfm);

  const double velocity =
      normal.dot(contact.a.getVelocityInLocalPoint(contact.armA) - contact.b.getVelocityInLocalPoint(contact.armB));
  double bias = std::max(0.0, point.m_combinedRestitution * -velocity) - velocityAlong(row, true);
  const double distance = point.getDistance();
  double depthRate = 0;
  if (distance > 0) {
    bias -= distance * rate;
  } else {
    depthRate = -distance * settings_.contactErp * rate;
  }
  row.rhs = bias * row.effectiveMass;
  row.rhs += row.effectiveMass * bounceChange(point, contact.a, contact.b, dt_);
  // deep overlap comes from placing, not from motion, so it is pushed out at a limited speed
  row.rhs += std::min(depthRate, kMaxPushAcceleration * dt_) * row.effectiveMass;
  row.cfm = cfm * row.effectiveMass;
  row.impulse = point.m_appliedImpulse * kWarmStart;
  apply(row, row.impulse);
  normals_.push_back(row);
  points_.push_back(&point);

  if (!contact.friction.isDirected) {
    const auto velocityOf = [this](const btRigidBody& rigid, const btVector3& arm) {
      const Body& body = bodies_[numberOf(rigid)];
      return rigid.getLinearVelocity() + body.forceChange + (rigid.getAngularVelocity() + body.torqueChange).cross(arm);
    };
    contact.chooseDirections(velocityOf(contact.a, contact.armA) - velocityOf(contact.b, contact.armB));
  }
  const PointFriction& friction = contact.friction;
  addFriction(contact, point.m_lateralFrictionDir1, point.m_combinedFriction, friction.slip1, point.m_contactMotion1);
  addFriction(contact, point.m_lateralFrictionDir2, friction.mu2, friction.slip2, point.m_contactMotion2);
  if (friction.torsion > 0) addTorsion(contact);
}

// friction does not see the torques of this step, as in Bullet
void GaussSeidel::addFriction(const SolverContact& contact, const btVector3& direction, double mu, double slip,
                              double motion) {
  FrictionRow row{makeRow(contact, direction, 0), mu, normals_.size() - 1};
  row.rhs = (motion - velocityAlong(row, false)) * row.effectiveMass;
  addSlip(row, slip);
  frictions_.push_back(row);
}

void GaussSeidel::addTorsion(const SolverContact& contact) {
  const btVector3& normal = contact.point.m_normalWorldOnB;
  FrictionRow row{{numberOf(contact.a),
                   numberOf(contact.b),
                   btVector3(0, 0, 0),
                   {normal, contact.a.getInvInertiaTensorWorld() * normal},
                   {-normal, contact.b.getInvInertiaTensorWorld() * -normal}},
                  contact.friction.torsion,
                  normals_.size() - 1};
  const double inverseInertia =
      isGeneral_ ? inverseMassOf(row) : row.angularA.response.dot(normal) + row.angularB.response.dot(-normal);
  row.effectiveMass = inverseInertia > 0 ? 1 / inverseInertia : 0;
  row.rhs = -velocityAlong(row, true) * row.effectiveMass;
  addSlip(row, contact.friction.torsionSlip);
  torsions_.push_back(row);
}

/// Lets the row slip at `slip` times its force: a compliance of slip / dt.
void GaussSeidel::addSlip(Row& row, double slip) const {
  if (slip <= 0 || row.effectiveMass == 0) return;
  const double rigid = row.effectiveMass;
  row.effectiveMass = 1 / (1 / rigid + slip / dt_);
  row.rhs *= row.effectiveMass / rigid;
  row.cfm = slip / dt_ * row.effectiveMass;
}

/// @return Whether any impulse has changed.
bool GaussSeidel::sweep() {
  bool hasChanged = false;
  for (FrictionRow& row : torsions_) hasChanged |= improve(row);
  auto third = thirdBodies_.begin();
  for (std::size_t i = 0; i < jointRows_.size(); ++i) {
    if (third == thirdBodies_.end() || third->row != i) {
      hasChanged |= improve(jointRows_[i]);
      continue;
    }
    Body& body = bodies_[third->body];
    const double before = jointRows_[i].impulse;
    hasChanged |= improve(jointRows_[i], third->angular.jacobian.dot(body.angularChange));
    const double change = jointRows_[i].impulse - before;
    if (isGeneral_) {
      applyGenerally(third->body, btVector3(0, 0, 0), third->angular.jacobian, change);
    } else {
      body.angularChange += third->angular.response * change;
    }
    ++third;
  }
  for (Row& row : normals_) hasChanged |= improve(row);
  for (FrictionRow& row : frictions_) {
    if (normals_[row.normal].impulse > 0) hasChanged |= improve(row);
  }
  return hasChanged;
}

bool GaussSeidel::improve(FrictionRow& row) {
  row.highest = row.mu * normals_[row.normal].impulse;
  row.lowest = -row.highest;
  return improve(static_cast<Row&>(row));
}

/// Gives the row the impulse that it lacks, within its bounds.
/// @param ofThirdBody Velocity along the row of the third body.
/// @return Whether the impulse has changed.
bool GaussSeidel::improve(Row& row, double ofThirdBody) {
  const Body &a = bodies_[row.a], &b = bodies_[row.b];
  const double velocityA = row.linear.dot(a.linearChange) + row.angularA.jacobian.dot(a.angularChange);
  const double velocityB = row.angularB.jacobian.dot(b.angularChange) - row.linear.dot(b.linearChange);
  double change = row.rhs - row.impulse * row.cfm;
  change -= velocityA * row.effectiveMass;
  change -= velocityB * row.effectiveMass;
  change -= ofThirdBody * row.effectiveMass;
  const double sum = row.impulse + change;
  const double clamped = sum < row.lowest ? row.lowest : sum > row.highest ? row.highest : sum;
  if (clamped != sum) change = clamped - row.impulse;
  row.impulse = clamped;
  apply(row, change);
  return change != 0;
}

void GaussSeidel::apply(const Row& row, double impulse) {
  if (isGeneral_) {
    applyGenerally(row.a, row.linear, row.angularA.jacobian, impulse);
    applyGenerally(row.b, -row.linear, row.angularB.jacobian, impulse);
    return;
  }
  Body &a = bodies_[row.a], &b = bodies_[row.b];
  a.linearChange += row.linear * a.inverseMass * impulse;
  a.angularChange += row.angularA.response * impulse;
  b.linearChange -= row.linear * b.inverseMass * impulse;
  b.angularChange += row.angularB.response * impulse;
}

void GaussSeidel::writeBack() {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i]->m_appliedImpulse = normals_[i].impulse;
    points_[i]->m_appliedImpulseLateral1 = frictions_[2 * i].impulse;
    points_[i]->m_appliedImpulseLateral2 = frictions_[2 * i + 1].impulse;
  }
  for (const auto& [joint, first] : measured_) {
    btVector3 force(0, 0, 0), torque(0, 0, 0);
    for (std::size_t i = first; i < first + joint->rowCount(); ++i) {
      const Row& row = jointRows_[i];
      force += -row.linear * row.impulse / dt_;
      torque += row.angularB.jacobian * row.impulse / dt_;
    }
    joint->setReaction(force, torque);
  }
  for (const Body& each : std::span(bodies_).subspan(1)) {
    btRigidBody& body = *each.body;
    body.setLinearVelocity(body.getLinearVelocity() + each.linearChange + each.forceChange);
    body.setAngularVelocity(body.getAngularVelocity() + each.angularChange + each.torqueChange);
  }
}

}  // namespace pongsim::physics
