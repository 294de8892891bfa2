#include "physics/contacts/collision_configuration.hh"

#include <gtest/gtest.h>

#include <memory>

#include "support/physics/rig.hh"
#include "support/solids.hh"

namespace pongsim::physics {
namespace {

using test::Rig;

TEST(CollisionConfiguration, PassesOverNoPieceThatTouchesAPlane) {
  // the plane and what stands on it lie askew in the world
  const Pose X_WorldPlane({1, -2, 3}, fromRollPitchYaw(0.7, -0.4, 1.1));
  description::Mesh iron;
  iron.triangles = std::make_shared<const description::TriangleMesh>(test::angleIron(0.1, 0.1));
  for (const double turn : {0.0, 1.0, 2.5}) {
    description::Link link = test::makeLink("link", {0, 0, 0}, 4, {0.02, 0.02, 0.02});
    link.inertial.X_LinkCom.position = {0.125, 0, 0.075};
    link.X_ModelLink = X_WorldPlane * Pose({0.3, 0.2, 0.001}, fromRollPitchYaw(0, 0, turn));
    test::addCollision(link, iron);
    description::Model ground = test::makeGround();
    ground.links[0].X_ModelLink = X_WorldPlane;
    description::World world;
    world.models = {ground, test::makeModel("iron", {link})};
    world.gravity = X_WorldPlane.rotation * Vector3(0, 0, -9.8);
    Rig rig(std::move(world));
    rig.step(1000);
    const Pose X_PlaneIron = X_WorldPlane.inverse() * rig.link("iron::link").X_WorldLink;
    EXPECT_NEAR(X_PlaneIron.position.z(), 0, 1e-4) << turn;
    // it stands on all of its leg
    EXPECT_NEAR((X_PlaneIron * Vector3(0.3, 0, 0)).z(), 0, 1e-4) << turn;
  }
}

}  // namespace
}  // namespace pongsim::physics
