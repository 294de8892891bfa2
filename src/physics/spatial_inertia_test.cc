// Bodies with fluid added mass, compared with mechanics.

#include "physics/spatial_inertia.hh"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <utility>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::AddedMass;
using test::Rig;
using Twist = Eigen::Matrix<double, 6, 1>;

constexpr double kDt = 0.001;

Rig swimmer(const description::Link& link, const Vector3& gravity = Vector3::Zero()) {
  description::World world;
  world.gravity = gravity;
  world.models = {test::makeModel("body", {link})};
  return Rig(std::move(world));
}

description::Link linkWith(const AddedMass& added) {
  description::Link link = test::makeLink("link", {0, 0, 0}, 2, {0.5, 0.6, 0.7});
  link.inertial.addedMass = added;
  return link;
}

AddedMass diagonal(double x, double y, double z, double p, double q, double r) {
  return Twist(x, y, z, p, q, r).asDiagonal();
}

void couple(AddedMass& added, int row, int column, double value) { added(row, column) = added(column, row) = value; }

/// All elements, about a point that is not the centre of mass.
AddedMass crowded() {
  AddedMass added = diagonal(3, 5, 8, 0.6, 0.9, 1.2);
  const double values[] = {0.4, -0.3, 0.2, 0.5, -0.1, 0.6, 0.1, -0.4, 0.3, 0.2, 0.7, -0.2, 0.1, -0.1, 0.2};
  int i = 0;
  for (int row = 0; row < 6; ++row) {
    for (int column = row + 1; column < 6; ++column) couple(added, row, column, values[i++]);
  }
  return added;
}

description::Link crowdedLink() {
  description::Link link = linkWith(crowded());
  link.inertial.X_LinkCom = {{0.2, -0.1, 0.3}, fromRollPitchYaw(0.3, 0.5, -0.4)};
  link.inertial.moments(0, 1) = link.inertial.moments(1, 0) = 0.1;
  return link;
}

/// The inertia of body and fluid about the origin of the link frame.
AddedMass inertiaOf(const description::Link& link) {
  const description::Inertial& own = link.inertial;
  const Vector3& c = own.X_LinkCom.position;
  Matrix3 cross;
  cross << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  const Matrix3 R = own.X_LinkCom.rotation.toRotationMatrix();
  AddedMass sum = *own.addedMass;
  sum.topLeftCorner<3, 3>() += own.mass * Matrix3::Identity();
  sum.topRightCorner<3, 3>() -= own.mass * cross;
  sum.bottomLeftCorner<3, 3>() += own.mass * cross;
  sum.bottomRightCorner<3, 3>() += R * own.moments * R.transpose() - own.mass * cross * cross;
  return sum;
}

Twist twistOf(const world::LinkState& state) { return (Twist() << state.v_WorldLink, state.w_WorldLink).finished(); }

TEST(SpatialInertia, AcceleratesAsForceOverMassAndAddedMass) {
  Rig rig = swimmer(linkWith(diagonal(8, 3, 18, 0.5, 1.4, 3.3)));
  rig.engine.addLinkWrench(0, {20, 30, 40}, {2, 4, 8});
  rig.step();
  const Twist expected = kDt * Twist(2, 6, 2, 2, 2, 2);
  EXPECT_TRUE(twistOf(rig.link("body::link")).isApprox(expected, 1e-10)) << twistOf(rig.link("body::link")).transpose();
}

TEST(SpatialInertia, TurnsAForceAsideByWhatIsBesideTheDiagonal) {
  AddedMass added = AddedMass::Zero();
  couple(added, 0, 1, 1);
  couple(added, 2, 4, 0.5);
  Rig rig = swimmer(linkWith(added));
  rig.engine.addLinkWrench(0, {3, 0, 1.9}, {0, 0, 0});
  rig.step();
  // 2 a + b = 3 and a + 2 b = 0; 2 c + 0.5 q = 1.9 and 0.5 c + 0.6 q = 0
  const Twist expected = kDt * Twist(2, -1, 1.2, 0, -1, 0);
  EXPECT_TRUE(twistOf(rig.link("body::link")).isApprox(expected, 1e-10)) << twistOf(rig.link("body::link")).transpose();
}

TEST(SpatialInertia, IsPulledByTheWeightOfItsOwnMassOnly) {
  Rig rig = swimmer(linkWith(diagonal(0, 0, 6, 0, 0, 0)), {0, 0, -9.8});
  rig.step(100);
  EXPECT_NEAR(rig.link("body::link").v_WorldLink.z(), -9.8 * 2 / 8 * 0.1, 1e-12);
  // its own mass pulls at the centre of mass
  const description::Link link = crowdedLink();
  Rig other = swimmer(link, {0, 0, -9.8});
  other.step();
  const Vector3 weight(0, 0, -9.8 * 2);
  const Twist wrench = (Twist() << weight, link.inertial.X_LinkCom.position.cross(weight)).finished();
  const Twist expected = kDt * inertiaOf(link).inverse() * wrench;
  EXPECT_TRUE(twistOf(other.link("body::link")).isApprox(expected, 1e-4));
}

TEST(SpatialInertia, IsThatOfTheLinkFrameInItsAxes) {
  const description::Link link = crowdedLink();
  description::Model model = test::makeModel("body", {link});
  model.X_ParentModel = {{4, 5, 6}, fromRollPitchYaw(0.7, -0.2, 1.9)};
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  Rig rig(world);
  const Twist wrench(1, 2, -3, 4, -5, 6);
  rig.engine.addLinkWrench(0, wrench.head<3>(), wrench.tail<3>());
  rig.step();
  const Matrix3 R = model.X_ParentModel.rotation.toRotationMatrix();
  Eigen::Matrix<double, 6, 6> turn = Eigen::Matrix<double, 6, 6>::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R;
  const Twist expected = kDt * turn * inertiaOf(link).inverse() * turn.transpose() * wrench;
  EXPECT_TRUE(twistOf(rig.link("body::link")).isApprox(expected, 1e-4));
}

/// Kirchhoff's equations in the link frame, by Runge and Kutta's method of order four: P and L are momentum and angular
/// momentum about the link's origin, dP/dt = P x w + f, dL/dt = L x w + P x v + t.
struct Reference {
  explicit Reference(const description::Link& link) : M(inertiaOf(link)), inverse(M.inverse()) {}
  struct State {
    Vector3 position = Vector3::Zero();
    Eigen::Vector4d rotation{0, 0, 0, 1};
    Twist momentum = Twist::Zero();
    State operator+(const State& o) const {
      return {position + o.position, rotation + o.rotation, momentum + o.momentum};
    }
    State operator*(double f) const { return {f * position, f * rotation, f * momentum}; }
  };
  static Quaternion turn(const State& s) { return Quaternion(s.rotation).normalized(); }
  State rate(const State& s, const Vector3& force, const Vector3& torque) const {
    const Quaternion q = turn(s);
    const Twist V = inverse * s.momentum;
    const Vector3 v = V.head<3>(), w = V.tail<3>(), P = s.momentum.head<3>(), L = s.momentum.tail<3>();
    State result;
    result.position = q * v;
    result.rotation = (q * Quaternion(0, w.x() / 2, w.y() / 2, w.z() / 2)).coeffs();
    result.momentum << P.cross(w) + q.conjugate() * force, L.cross(w) + P.cross(v) + q.conjugate() * torque;
    return result;
  }
  void step(double h, const Vector3& force, const Vector3& torque) {
    const State a = rate(now, force, torque), b = rate(now + a * (h / 2), force, torque);
    const State c = rate(now + b * (h / 2), force, torque), d = rate(now + c * h, force, torque);
    now = now + (a + b * 2 + c * 2 + d) * (h / 6);
    now.rotation.normalize();
  }
  double energy() const { return now.momentum.dot(inverse * now.momentum) / 2; }
  AddedMass M;
  AddedMass inverse;
  State now;
};

TEST(SpatialInertia, MovesAsKirchhoffsEquationsSay) {
  const description::Link link = crowdedLink();
  Rig rig = swimmer(link);
  Reference reference(link);
  for (int i = 0; i < 3000; ++i) {
    const double t = i * kDt;
    const Vector3 force(5 * std::sin(3 * t), 4, -3 * std::cos(2 * t)), torque(0.5, std::sin(t), -0.4);
    rig.engine.addLinkWrench(0, force, torque);
    rig.step();
    reference.step(kDt, force, torque);
  }
  const world::LinkState& body = rig.link("body::link");
  EXPECT_GT(reference.now.position.norm(), 2);
  EXPECT_LT((body.X_WorldLink.position - reference.now.position).norm(), 3e-3);
  EXPECT_LT(body.X_WorldLink.rotation.angularDistance(Reference::turn(reference.now)), 3e-3);
}

TEST(SpatialInertia, KeepsMomentumAndEnergyOfAFreeBody) {
  const description::Link link = crowdedLink();
  Rig rig = swimmer(link);
  rig.engine.setLinkVelocity(0, {0.9, -0.4, 0.2}, {0.5, 1.5, -0.3});
  const AddedMass M = inertiaOf(link);
  const auto inBody = [&] {
    const world::LinkState& state = rig.link("body::link");
    const Quaternion back = state.X_WorldLink.rotation.conjugate();
    return (Twist() << back * state.v_WorldLink, back * state.w_WorldLink).finished();
  };
  const Twist start = (Twist() << 0.9, -0.4, 0.2, 0.5, 1.5, -0.3).finished();
  const double energy = start.dot(M * start) / 2;
  const Vector3 momentum = (M * start).head<3>();
  for (int i = 0; i < 10000; ++i) {
    rig.step();
    const Twist V = inBody();
    ASSERT_NEAR(V.dot(M * V) / 2 / energy, 1, 3e-3) << i;
    const Vector3 P = rig.link("body::link").X_WorldLink.rotation * Vector3((M * V).head<3>());
    ASSERT_LT((P - momentum).norm(), 3e-3 * momentum.norm()) << i;
  }
}

// A spheroid of 2 x 1 x 1 m in water, as its density and the formulas of H. Lamb have it. The values are those that
// gz-sim's test of added mass requires of Gazebo with DART, within its tolerances.
TEST(SpatialInertia, MovesAsInGazebo) {
  description::Link link = test::makeLink("link", {0, 0, 0}, 1073.3774899765126,
                                          {107.33774899765126, 268.34437249412815, 268.34437249412815});
  link.inertial.addedMass =
      diagonal(236.14304779483277, 901.6370915802705, 901.6370915802705, 0, 64.40264939859075, 64.40264939859075);
  Rig rig = swimmer(link);
  for (int i = 1; i <= 1000; ++i) {
    const double force = 2000 * std::sin(3 * std::numbers::pi * i * kDt);
    const double torque = 200 * std::sin(2 * std::numbers::pi * i * kDt);
    rig.engine.addLinkWrench(0, {force, force, 0}, {torque, torque, 0});
    rig.step();
  }
  const world::LinkState& body = rig.link("body::link");
  const Eigen::AngleAxisd turn(body.X_WorldLink.rotation);
  EXPECT_LT((body.X_WorldLink.position - Vector3(0.1615036, 0.1071017, -0.0024940)).norm(), 1e-3);
  EXPECT_NEAR(turn.angle(), 0.3135110, 1e-5);
  EXPECT_LT((turn.axis() - Vector3(0.9487133, 0.2967466, -0.1090158)).norm(), 1e-4);
  EXPECT_LT((body.v_WorldLink - Vector3(0.3208749, 0.2127726, -0.0102837)).norm(), 2e-5);
  EXPECT_LT((body.w_WorldLink - Vector3(0.0031500, 0.0022452, -0.0525643)).norm(), 1e-4);
}

/// A base that is fixed to the world, and an arm with added mass.
description::World armWith(description::JointType type, const Vector3& axis) {
  description::World world = test::twoLinks(type, axis);
  description::Link& arm = world.models[0].links[1];
  arm.inertial = crowdedLink().inertial;
  return world;
}

TEST(SpatialInertia, LetsAJointTurnOrSlideByItsShare) {
  const description::World turning = armWith(description::JointType::kRevolute, Vector3::UnitZ());
  const AddedMass M = inertiaOf(turning.models[0].links[1]);
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    Rig hinge(turning, {.solver = solver, .iterations = 20000});
    hinge.engine.addJointForce(0, 6);
    hinge.step();
    EXPECT_NEAR(hinge.joint(0).velocity / (6 * kDt / M(5, 5)), 1, 1e-3);
    Rig slider(armWith(description::JointType::kPrismatic, Vector3::UnitY()), {.solver = solver, .iterations = 20000});
    slider.engine.addJointForce(0, 6);
    slider.step();
    EXPECT_NEAR(slider.joint(0).velocity / (6 * kDt / M(1, 1)), 1, 1e-3);
  }
}

// with and without a tree, and with a gearbox, whose rows have a third body
TEST(SpatialInertia, IsTheSameForBothSolvers) {
  description::World chain;
  description::Model model = test::makeModel("chain", {test::makeLink("l0", {0, 0, 0}, 1, {0.1, 0.1, 0.1})});
  for (int i = 1; i < 5; ++i) {
    description::Link link = test::makeLink("l" + std::to_string(i), {0.5 * i, 0, 0}, 1, {0.1, 0.2, 0.1});
    if (i % 2 == 1) link.inertial.addedMass = crowded();
    model.links.push_back(link);
    model.joints.push_back(test::makeJoint("j" + std::to_string(i), description::JointType::kRevolute,
                                           "l" + std::to_string(i - 1), link.name, test::at(0.25, 0, 0),
                                           test::at(-0.25, 0, 0), i % 2 == 0 ? Vector3::UnitY() : Vector3::UnitZ()));
  }
  chain.models = {model};
  description::World gears;
  gears.models = {test::makeGearTrain(1.5)};
  for (description::Link& link : gears.models[0].links) link.inertial.addedMass = crowded();
  for (const description::World& world : {chain, gears}) {
    Rig direct(world), iterative(world, {.solver = Solver::kGaussSeidel, .iterations = 20000});
    for (Rig* rig : {&direct, &iterative}) {
      rig->engine.addJointForce(0, 3);
      rig->step();
    }
    for (std::size_t i = 0; i < direct.state.links.size(); ++i) {
      const Twist one = twistOf(direct.state.links[i]), other = twistOf(iterative.state.links[i]);
      EXPECT_LT((one - other).norm(), 3e-5) << i << ": " << one.transpose();
    }
  }
}

TEST(SpatialInertia, LiesOnTheGroundWithItsWeight) {
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    description::Link link = linkWith(diagonal(3, 3, 6, 0.1, 0.1, 0.1));
    test::addCollision(link, description::Box{{1, 1, 1}}, 0.5);
    link.X_ModelLink.position.z() = 0.52;
    description::World world;
    world.models = {test::makeGround(), test::makeModel("body", {link})};
    Rig rig(world, {.solver = solver});
    rig.step(1000);
    const world::LinkState& body = rig.link("body::link");
    EXPECT_NEAR(body.X_WorldLink.position.z(), 0.5, 1e-4);
    EXPECT_LT(twistOf(body).norm(), 1e-4);
    // pushed by twice what friction holds, it slides: (2 - 1) mu m g / (m + ma)
    rig.engine.addLinkWrench(1, {2 * 9.8, 0, 0}, {0, 0, 0});
    rig.step();
    EXPECT_NEAR(rig.link("body::link").v_WorldLink.x() / (9.8 / 5 * kDt), 1, 0.05);
  }
}

}  // namespace
}  // namespace pongsim::physics
