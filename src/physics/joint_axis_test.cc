// What acts along the axes of joints: damping, friction, springs, and axes that mimic others.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "physics/joint.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;
using test::at;
using test::makeJoint;
using test::makeLink;
using test::Rig;
using test::twoLinks;

TEST(Joint, LosesSpeedByDampingAndFriction) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
  world.models[0].joints[0].axes[0].damping = 0.1;
  Rig damped(world);
  damped.engine.addJointForce(0, 1000);
  damped.step(1);
  const double start = damped.joint(0).velocity;
  damped.step(1000);
  // v' = -d / I v: a time constant of 1 s
  EXPECT_NEAR(damped.joint(0).velocity / start, std::exp(-1), 1e-3);

  world.models[0].joints[0].axes[0].damping = 0;
  world.models[0].joints[0].axes[0].friction = 0.2;
  Rig rubbed(world);
  rubbed.engine.addJointForce(0, 200.2);
  rubbed.step(1);
  EXPECT_NEAR(rubbed.joint(0).velocity, 2, 1e-3);
  rubbed.step(500);
  EXPECT_NEAR(rubbed.joint(0).velocity, 1, 1e-3);
  rubbed.step(1000);
  EXPECT_NEAR(rubbed.joint(0).velocity, 0, 1e-6);
}

/// Velocities and positions of a link of this inertia on a hinge, under a constant torque, by Fortress's DART:
/// (I + h d + h^2 k) dv = h (torque - k (q + h v - q0) - d v).
struct DartHinge {
  double inertia, damping, stiffness, reference, torque, dt;
  double q = 0, v = 0;

  void step() {
    v += dt * (torque - stiffness * (q + dt * v - reference) - damping * v) /
         (inertia + dt * damping + dt * dt * stiffness);
    q += dt * v;
  }
};

TEST(Joint, DampsAndSpringsAnyInertiaAsDartDoes) {
  for (const Solver solver : {Solver::kDirect, Solver::kGaussSeidel}) {
    for (const double inertia : {1e-7, 1e-5, 1e-3, 1.0}) {
      for (const int milliseconds : {1, 2, 4}) {
        for (const double stiffness : {0.0, 0.5}) {
          description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
          world.models[0].links[1].inertial = {0.01, Pose(), Matrix3(inertia * Matrix3::Identity())};
          description::JointAxis& axis = world.models[0].joints[0].axes[0];
          axis.damping = 0.02;
          axis.springStiffness = stiffness;
          axis.springReference = 0.1;
          Settings settings;
          settings.solver = solver;
          Rig rig(std::move(world), settings);
          DartHinge dart{inertia, 0.02, stiffness, 0.1, 0.05, milliseconds * 1e-3};
          for (int i = 0; i < 100; ++i) {
            rig.engine.addJointForce(0, 0.05);
            rig.engine.step(std::chrono::milliseconds(milliseconds), rig.state);
            dart.step();
          }
          EXPECT_NEAR(rig.joint(0).position, dart.q, 0.01 * std::abs(dart.q)) << inertia << " " << milliseconds;
          EXPECT_NEAR(rig.joint(0).velocity, dart.v, 0.01 * std::abs(dart.v) + 1e-4) << inertia << " " << milliseconds;
        }
      }
    }
  }
}

TEST(Joint, FollowsTheOneThatItMimics) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
  description::Model& model = world.models[0];
  model.links.push_back(makeLink("finger", {-1, 0, 0}, 1, {0.1, 0.1, 0.1}));
  model.joints.push_back(
      makeJoint("slide", JointType::kPrismatic, "base", "finger", at(-1, 0, 0), Pose(), Vector3::UnitX()));
  model.joints.back().axes[0].mimic = description::Mimic{"joint", {}, 0, -0.5, 0.1, 0};
  Rig rig(world);
  rig.step(1);
  EXPECT_NEAR(rig.joint(2).position, 0.1, 1e-6);
  for (int i = 0; i < 1000; ++i) {
    rig.engine.setJointVelocityTarget(0, std::sin(i * 0.01));
    rig.step();
    ASSERT_NEAR(rig.joint(2).position, 0.1 - 0.5 * rig.joint(0).position, 1e-4) << i;
  }
  // what is commanded itself does not follow
  rig.engine.setJointVelocityTarget(2, 0);
  const double before = rig.joint(2).position;
  rig.step(100);
  EXPECT_NEAR(rig.joint(2).position, before, 1e-6);

  // with all its effort, and no more
  world.models[0].joints.back().axes[0].effort = 1;
  Rig weak(world);
  weak.step(1);
  EXPECT_NEAR(weak.joint(2).velocity, 1e-3, 1e-6);
}

TEST(Joint, SwingsOnASpring) {
  description::World world = twoLinks(JointType::kRevolute, Vector3::UnitZ());
  world.models[0].joints[0].axes[0].springStiffness = 10;
  world.models[0].joints[0].axes[0].springReference = 0.3;
  Rig rig(std::move(world));
  // omega = sqrt(k / I) = 10: half a period takes it to twice the reference, less what an implicit step loses: the
  // swing fades by exp(-h omega^2 t / 2)
  rig.step(314);
  EXPECT_NEAR(rig.joint(0).position, 0.3 * (1 + std::exp(-0.05 * 0.314)), 1e-3);
  rig.step(314);
  EXPECT_NEAR(rig.joint(0).position, 0.3 * (1 - std::exp(-0.05 * 0.628)), 2e-3);
}

}  // namespace
}  // namespace pongsim::physics
