#include "physics/joint.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;
using test::at;
using test::makeJoint;
using test::makeLink;
using test::makeModel;
using test::Rig;
using test::twoLinks;

constexpr double kGravity = 9.8;

TEST(Joint, TurnsTheChildPositivelyAboutTheAxis) {
  Rig rig(twoLinks(JointType::kRevolute, Vector3::UnitY(), false));
  rig.engine.setJointVelocityTarget(0, 2);
  rig.step(1);
  EXPECT_NEAR(rig.joint(0).velocity, 2, 1e-5);
  EXPECT_GT(rig.link("model::arm").w_WorldLink.y(), 0);
  EXPECT_LT(rig.link("model::base").w_WorldLink.y(), 0);
  EXPECT_NEAR(rig.link("model::arm").w_WorldLink.y() - rig.link("model::base").w_WorldLink.y(), 2, 1e-5);
}

TEST(Joint, IsDrivenUntilItIsReleased) {
  Rig rig(twoLinks(JointType::kRevolute, Vector3::UnitZ()));
  EXPECT_FALSE(rig.engine.isJointDriven(0));
  rig.engine.setJointVelocityTarget(0, 0);
  EXPECT_FALSE(rig.engine.isJointDriven(0));
  rig.engine.setJointVelocityTarget(0, 2);
  EXPECT_TRUE(rig.engine.isJointDriven(0));
  rig.step(10);
  EXPECT_TRUE(rig.engine.isJointDriven(0));
  // it turns on, and nothing holds it against a force
  rig.engine.addJointForce(0, 100);
  rig.engine.releaseJoint(0);
  EXPECT_FALSE(rig.engine.isJointDriven(0));
  rig.step(10);
  EXPECT_NEAR(rig.joint(0).velocity, 2, 1e-3);
  rig.engine.addJointForce(0, 100);
  EXPECT_TRUE(rig.engine.isJointDriven(0));
  rig.step(1);
  EXPECT_FALSE(rig.engine.isJointDriven(0));
  EXPECT_GT(rig.joint(0).velocity, 2.01);
}

TEST(Joint, CountsTheAngleOverManyTurns) {
  for (double velocity : {20.0, -20.0}) {
    Rig rig(twoLinks(JointType::kContinuous, Vector3(1, 2, 2).normalized()));
    rig.engine.setJointVelocityTarget(0, velocity);
    rig.step(10000);
    EXPECT_NEAR(rig.joint(0).position, 10 * velocity, 1e-3);
  }
}

TEST(Joint, ReachesTheTargetVelocityUpToItsEffort) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
  world.models[0].joints[0].axes[0].effort = 0.5;
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 10);
  rig.step(100);
  // 0.5 N m on 0.1 kg m^2 for 0.1 s
  EXPECT_NEAR(rig.joint(0).velocity, 0.5, 1e-4);
  rig.step(3000);
  EXPECT_NEAR(rig.joint(0).velocity, 10, 1e-4);
}

TEST(Joint, KeepsToItsVelocityLimit) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
  world.models[0].joints[0].axes[0].velocity = 3;
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, -10);
  rig.step(10);
  EXPECT_NEAR(rig.joint(0).velocity, -3, 1e-6);
}

TEST(Joint, TakesAForceForOneStep) {
  Rig rig(twoLinks(JointType::kRevolute, Vector3::UnitZ()));
  rig.engine.addJointForce(0, 2);
  rig.engine.addJointForce(0, 3);
  rig.step(1);
  EXPECT_NEAR(rig.joint(0).velocity, 5 * 0.001 / 0.1, 1e-6);
  rig.step(10);
  EXPECT_NEAR(rig.joint(0).velocity, 5 * 0.001 / 0.1, 1e-6);
}

TEST(Joint, StopsAtTheLimitsOfATurningAxis) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
  world.models[0].joints[0].axes[0].lower = -0.5;
  world.models[0].joints[0].axes[0].upper = 1;
  Rig rig(std::move(world));
  for (double velocity : {5.0, -5.0}) {
    rig.engine.setJointVelocityTarget(0, velocity);
    rig.step(1000);
    EXPECT_NEAR(rig.joint(0).position, velocity > 0 ? 1 : -0.5, 1e-4);
    EXPECT_NEAR(rig.joint(0).velocity, 0, 1e-4);
  }
}

// many files lock a joint in this way
TEST(Joint, HoldsAnAxisWhoseLimitsAreNearEachOther) {
  for (const double gap : {0.0, 1e-4}) {
    description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
    world.models[0].joints[0].axes[0].lower = 0;
    world.models[0].joints[0].axes[0].upper = gap;
    Rig rig(std::move(world));
    for (int i = 0; i < 200; ++i) {
      rig.engine.addJointForce(0, i / 20 % 2 == 0 ? 50 : -50);
      rig.step(1);
      ASSERT_GT(rig.joint(0).position, -1e-5) << gap << " " << i;
      ASSERT_LT(rig.joint(0).position, gap + 1e-5) << gap << " " << i;
    }
  }
}

TEST(Joint, StopsAFallingSliderAtItsLimit) {
  description::World world = twoLinks(JointType::kPrismatic, Vector3::UnitZ());
  world.gravity.z() = -kGravity;
  world.models[0].joints[0].axes[0].lower = -0.25;
  Rig rig(std::move(world));
  double lowest = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.step(1);
    lowest = std::min(lowest, rig.joint(0).position);
  }
  EXPECT_GT(lowest, -0.2501);
  EXPECT_NEAR(rig.joint(0).position, -0.25, 1e-4);
  EXPECT_NEAR(rig.link("model::arm").X_WorldLink.position.z(), -0.25, 1e-4);
  EXPECT_NEAR(rig.link("model::arm").X_WorldLink.position.x(), 1, 1e-4);
}

TEST(Joint, SlidesTheChildAlongTheAxis) {
  Rig rig(twoLinks(JointType::kPrismatic, Vector3::UnitY(), false));
  rig.engine.setJointVelocityTarget(0, 0.5);
  rig.step(1000);
  EXPECT_NEAR(rig.joint(0).position, 0.5, 1e-4);
  EXPECT_GT(rig.link("model::arm").X_WorldLink.position.y(), rig.link("model::base").X_WorldLink.position.y());
}

TEST(Joint, SwingsWithAPendulumsPeriod) {
  // 1 kg of 0.1 kg m^2, 1 m below its joint
  description::Model model = makeModel("model", {makeLink("bob", {0, 0, -1}, 1, {0.1, 0.1, 0.1})});
  model.joints.push_back(
      makeJoint("joint", JointType::kRevolute, "world", "bob", Pose(), at(0, 0, 1), Vector3::UnitY()));
  description::World world;
  world.gravity = {0, 0, -kGravity};
  world.models = {model};
  Rig rig(std::move(world));
  rig.engine.addJointForce(0, 100);
  rig.step(1);
  int crossings = 0;
  int lastCrossing = 0;
  for (int i = 1; i <= 20000; ++i) {
    const double before = rig.joint(0).position;
    rig.step(1);
    if (before < 0 && rig.joint(0).position >= 0) {
      ++crossings;
      lastCrossing = i;
    }
  }
  // T = 2 pi sqrt(I / (m g l)) (1 + a^2 / 16)
  const double amplitude = 100 * 0.001 / 1.1 / std::sqrt(kGravity / 1.1);
  const double period = 2 * M_PI * std::sqrt(1.1 / kGravity) * (1 + amplitude * amplitude / 16);
  ASSERT_GT(crossings, 5);
  EXPECT_NEAR(lastCrossing * 0.001 / crossings, period, 0.002 * period);
  EXPECT_LT(rig.link("model::bob").X_WorldLink.position.norm(), 1 + 1e-4);
}

TEST(Joint, KeepsTheGapOfABallJointSmall) {
  description::Model model = makeModel("model", {makeLink("bob", {0, 1, 0}, 1, {0.1, 0.1, 0.1})});
  model.joints.push_back(makeJoint("joint", JointType::kBall, "world", "bob", at(0, 0, 0), at(0, -1, 0)));
  description::World world;
  world.gravity = {0, 0, -kGravity};
  world.models = {model};
  Rig rig(std::move(world));
  double gap = 0;
  for (int i = 0; i < 5000; ++i) {
    rig.step(1);
    gap = std::max(gap, (rig.link("model::bob").X_WorldLink * Vector3(0, -1, 0)).norm());
  }
  EXPECT_LT(gap, 5e-4);
}

TEST(Joint, HoldsAFixedChildInPlace) {
  description::World world = twoLinks(JointType::kFixed, Vector3::UnitZ());
  world.gravity.z() = -kGravity;
  Rig rig(std::move(world));
  rig.step(3000);
  EXPECT_TRUE(rig.link("model::arm").X_WorldLink.position.isApprox(Vector3(1, 0, 0), 1e-4));
  EXPECT_NEAR(rig.link("model::arm").X_WorldLink.rotation.w(), 1, 1e-6);
}

TEST(Joint, MayHaveTheWorldAsItsChild) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ(), false);
  world.models[0].joints.push_back(makeJoint("root", JointType::kFixed, "base", "world", Pose(), Pose()));
  world.gravity.z() = -kGravity;
  Rig rig(std::move(world));
  rig.step(1000);
  EXPECT_NEAR(rig.link("model::base").X_WorldLink.position.norm(), 0, 1e-4);
}

description::World crossOf(JointType type, const Vector3& second, bool baseIsFixed = true) {
  description::World world = twoLinks(type, Vector3::UnitX(), baseIsFixed);
  world.models[0].joints[0].axes.emplace_back().xyz = second;
  return world;
}

TEST(Joint, TurnsAboutBothAxesOfACross) {
  // the second one lies with the child, which the first one turns
  for (const Vector3& second : {Vector3(0, 1, 0), Vector3(0.6, 0.8, 0)}) {
    Rig rig(crossOf(JointType::kUniversal, second));
    rig.engine.setJointVelocityTarget(0, 0.5, 0);
    rig.engine.setJointVelocityTarget(0, -0.25, 1);
    rig.step(4000);
    EXPECT_NEAR(rig.joint(0).position, 2, 1e-3);
    EXPECT_NEAR(rig.joint(0).position2, -1, 1e-3);
    EXPECT_NEAR(rig.joint(0).velocity, 0.5, 1e-4);
    EXPECT_NEAR(rig.joint(0).velocity2, -0.25, 1e-4);
    const Quaternion expected =
        Eigen::AngleAxisd(rig.joint(0).position, Vector3::UnitX()) * Eigen::AngleAxisd(rig.joint(0).position2, second);
    EXPECT_LT(rig.link("model::arm").X_WorldLink.rotation.angularDistance(expected), 1e-4);
    EXPECT_LT((rig.link("model::arm").X_WorldLink.position - Vector3(1, 0, 0)).norm(), 1e-5);
  }
}

TEST(Joint, TurnsAboutTheAxesOfItsOwnFrameWhereThatIsTurnedInTheLinks) {
  const Quaternion turned(Eigen::AngleAxisd(0.7, Vector3(1, -2, 2) / 3));
  description::World world = crossOf(JointType::kUniversal, Vector3::UnitY());
  world.models[0].joints[0].X_ParentJoint.rotation = turned;
  world.models[0].joints[0].X_ChildJoint.rotation = turned;
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 0.5, 0);
  rig.engine.setJointVelocityTarget(0, -0.25, 1);
  rig.step(4000);
  EXPECT_NEAR(rig.joint(0).position, 2, 1e-3);
  EXPECT_NEAR(rig.joint(0).position2, -1, 1e-3);
  const Quaternion expected = turned * Eigen::AngleAxisd(rig.joint(0).position, Vector3::UnitX()) *
                              Eigen::AngleAxisd(rig.joint(0).position2, Vector3::UnitY()) * turned.inverse();
  EXPECT_LT(rig.link("model::arm").X_WorldLink.rotation.angularDistance(expected), 1e-4);
  EXPECT_LT((rig.link("model::arm").X_WorldLink.position - Vector3(1, 0, 0)).norm(), 1e-5);
}

TEST(Joint, CountsBothAnglesOfACrossOverManyTurns) {
  Rig rig(crossOf(JointType::kRevolute2, Vector3::UnitY()));
  rig.engine.setJointVelocityTarget(0, 20, 0);
  rig.engine.setJointVelocityTarget(0, -10, 1);
  rig.step(2000);
  EXPECT_NEAR(rig.joint(0).position, 40, 0.02);
  EXPECT_NEAR(rig.joint(0).position2, -20, 0.02);
}

TEST(Joint, CarriesAForceAlongOneAxisOfACrossToThatAlone) {
  Rig rig(crossOf(JointType::kUniversal, Vector3::UnitY()));
  rig.engine.addJointForce(0, 5, 1);
  rig.step(1);
  EXPECT_NEAR(rig.joint(0).velocity2, 5 * 0.001 / 0.1, 1e-6);
  EXPECT_NEAR(rig.joint(0).velocity, 0, 1e-9);
}

TEST(Joint, StopsACrossAtTheLimitsOfEachAxis) {
  description::World world = crossOf(JointType::kUniversal, Vector3::UnitY());
  world.models[0].joints[0].axes[1].upper = 0.5;
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 3, 1);
  rig.step(1000);
  EXPECT_NEAR(rig.joint(0).position2, 0.5, 1e-4);
  EXPECT_NEAR(rig.joint(0).position, 0, 1e-4);
}

TEST(Joint, ScrewsForwardAsItTurns) {
  for (double pitch : {0.1, -0.4}) {
    description::World world = twoLinks(JointType::kScrew, Vector3::UnitZ());
    world.models[0].joints[0].threadPitch = pitch;
    Rig rig(std::move(world));
    rig.engine.setJointVelocityTarget(0, 2 * M_PI);
    rig.step(3000);
    EXPECT_NEAR(rig.joint(0).position, 6 * M_PI, 0.02);
    EXPECT_NEAR(rig.link("model::arm").X_WorldLink.position.z(), pitch / (2 * M_PI) * rig.joint(0).position, 1e-5);
    EXPECT_NEAR(rig.link("model::arm").X_WorldLink.position.x(), 1, 1e-5);
  }
}

TEST(Joint, TurnsAScrewByTheWeightOnIt) {
  description::World world = twoLinks(JointType::kScrew, Vector3::UnitZ());
  world.gravity.z() = -kGravity;
  world.models[0].joints[0].threadPitch = 2 * M_PI * 0.2;
  Rig rig(std::move(world));
  rig.step(1000);
  // m g k = (I + m k^2) a
  EXPECT_NEAR(rig.joint(0).velocity, -kGravity * 0.2 / (0.1 + 0.04), 1e-2);
}

TEST(Joint, ClosesALoop) {
  // four bars: a square in the plane across y, its lower side fixed, pushed to a diamond
  description::Model model = makeModel(
      "model", {makeLink("left", {0, 0, 0.5}, 1, {0.1, 0.1, 0.1}), makeLink("right", {1, 0, 0.5}, 1, {0.1, 0.1, 0.1}),
                makeLink("top", {0.5, 0, 1}, 1, {0.1, 0.1, 0.1})});
  const auto hinge = [&](const char* name, const char* parent, const char* child, const Pose& inParent,
                         const Pose& inChild) {
    model.joints.push_back(makeJoint(name, JointType::kRevolute, parent, child, inParent, inChild, Vector3::UnitY()));
  };
  hinge("a", "world", "left", at(0, 0, 0), at(0, 0, -0.5));
  hinge("b", "world", "right", at(1, 0, 0), at(0, 0, -0.5));
  hinge("c", "left", "top", at(0, 0, 0.5), at(-0.5, 0, 0));
  hinge("d", "right", "top", at(0, 0, 0.5), at(0.5, 0, 0));
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(0, 0.3);
  double gap = 0;
  for (int i = 0; i < 2000; ++i) {
    rig.step(1);
    gap = std::max(gap, (rig.link("model::right").X_WorldLink * Vector3(0, 0, 0.5) -
                         rig.link("model::top").X_WorldLink * Vector3(0.5, 0, 0))
                            .norm());
  }
  EXPECT_NEAR(rig.joint(0).position, 0.6, 1e-3);
  EXPECT_NEAR(rig.joint(1).position, 0.6, 1e-3);
  EXPECT_NEAR(rig.link("model::top").X_WorldLink.position.z(), std::cos(0.6), 1e-3);
  EXPECT_NEAR(rig.link("model::top").w_WorldLink.y(), 0, 1e-3);
  EXPECT_LT(gap, 1e-4);
}

TEST(Joint, HoldsModelsTogetherAndPartsOfNestedOnes) {
  description::Model inner = makeModel("inner", {makeLink("tip", {0, 0, 0}, 1, {0.1, 0.1, 0.1})});
  inner.X_ParentModel.position = {1, 0, 0};
  description::Model outer = makeModel("outer", {makeLink("base", {0, 0, 0}, 5, {0.5, 0.5, 0.5})});
  outer.models = {inner};
  outer.joints.push_back(makeJoint("root", JointType::kFixed, "world", "base", Pose(), Pose()));
  outer.joints.push_back(
      makeJoint("elbow", JointType::kRevolute, "base", "inner::tip", at(1, 0, 0), Pose(), Vector3::UnitZ()));
  description::Model other = makeModel("other", {makeLink("link", {2, 0, 0}, 1, {0.1, 0.1, 0.1})});
  description::World world;
  world.gravity.setZero();
  world.models = {outer, other};
  world.joints.push_back(
      makeJoint("bridge", JointType::kFixed, "outer::inner::tip", "other::link", at(1, 0, 0), Pose()));
  Rig rig(std::move(world));
  rig.engine.setJointVelocityTarget(1, M_PI / 2);
  rig.step(1000);
  EXPECT_LT((rig.link("other::link").X_WorldLink.position - Vector3(1, 1, 0)).norm(), 3e-3);
}

TEST(Joint, RefusesCommandsWhereThereIsNoAxis) {
  Rig rig(twoLinks(JointType::kBall, Vector3::UnitZ()));
  EXPECT_THROW(rig.engine.setJointVelocityTarget(0, 1), std::invalid_argument);
  EXPECT_THROW(rig.engine.addJointForce(0, 1), std::invalid_argument);
  Rig hinged(twoLinks(JointType::kRevolute, Vector3::UnitZ()));
  EXPECT_THROW(hinged.engine.addJointForce(0, 1, 1), std::invalid_argument);
}

TEST(Joint, GearsTwoAxesTogetherAsTheRatioSays) {
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    description::World world;
    world.gravity.setZero();
    world.models = {test::makeGearTrain(2)};
    world.models[0].joints.push_back(makeJoint("root", JointType::kFixed, "world", "housing", Pose(), Pose()));
    Settings settings;
    settings.solver = solver;
    Rig rig(std::move(world), settings);
    for (int i = 0; i < 2000; ++i) {
      rig.engine.addJointForce(0, 3);
      rig.step();
    }
    // 3 N m on what turns about a: 0.1 kg m^2, and of b 0.05 kg m^2 times the ratio's square
    const double speed = 3 / (0.1 + 4 * 0.05) * 2;
    EXPECT_NEAR(rig.joint(0).velocity, speed, 1e-4 * speed);
    EXPECT_NEAR(rig.joint(1).velocity, -2 * speed, 2e-4 * speed);
    // many turns later
    EXPECT_NEAR(rig.joint(0).position, speed, 2e-3 * speed);
    EXPECT_NEAR(rig.joint(1).position, -2 * rig.joint(0).position, 1e-4);
    EXPECT_NEAR(rig.joint(2).position, rig.joint(0).position, 1e-9);
    EXPECT_NEAR(rig.joint(2).position2, rig.joint(1).position, 1e-9);
    EXPECT_THROW(rig.engine.addJointForce(2, 1), std::invalid_argument);
  }
}

TEST(Joint, GearsOnAHousingThatIsFreeToMove) {
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    description::World world;
    world.gravity.setZero();
    world.models = {test::makeGearTrain(-3)};
    Settings settings;
    settings.solver = solver;
    Rig rig(std::move(world), settings);
    const auto spin = [&] {
      Vector3 sum = Vector3::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        const description::Inertial& inertial = rig.entities.links()[i].description->inertial;
        const world::LinkState& link = rig.state.links[i];
        const Vector3 turn = link.X_WorldLink.rotation.conjugate() * link.w_WorldLink;
        sum += link.X_WorldLink.rotation * Vector3(inertial.moments * turn) +
               inertial.mass * link.X_WorldLink.position.cross(link.v_WorldLink);
      }
      return sum;
    };
    // what the gears push each other with is held by the housing: nothing comes from outside
    for (int i = 0; i < 1000; ++i) {
      if (i < 300) rig.engine.addJointForce(0, 1);
      rig.step();
      ASSERT_NEAR(rig.joint(1).velocity, 3 * rig.joint(0).velocity, 2e-3) << i;
    }
    EXPECT_GT(std::abs(rig.joint(0).velocity), 0.3);
    EXPECT_GT(rig.link("train::housing").w_WorldLink.norm(), 0.01);
    EXPECT_NEAR(rig.joint(1).position, 3 * rig.joint(0).position, 1e-3);
    EXPECT_LT(spin().norm(), 1e-4);
  }
}

}  // namespace
}  // namespace pongsim::physics
