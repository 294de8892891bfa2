#include "physics/contacts/contact_filter.hh"

#include <gtest/gtest.h>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;
using test::makeJoint;
using test::makeLink;
using test::makeModel;

// slots: ground 0; robot's body 1, wheel 2, hand 3; other 4
description::World crowd() {
  description::Model robot =
      makeModel("robot", {makeLink("body", {0, 0, 0}, 1, {1, 1, 1}), makeLink("wheel", {0, 0, 0}, 1, {1, 1, 1}),
                          makeLink("hand", {0, 0, 0}, 1, {1, 1, 1})});
  robot.joints.push_back(makeJoint("joint", JointType::kBall, "body", "wheel", Pose(), Pose()));
  description::World world;
  world.models = {test::makeGround(), robot, makeModel("other", {makeLink("link", {0, 0, 0}, 1, {1, 1, 1})})};
  return world;
}

TEST(ContactFilter, LetsModelsTouchEachOtherAndTheGround) {
  const description::World world = crowd();
  const world::Entities entities(world);
  const ContactFilter filter(entities);
  EXPECT_TRUE(filter.mayTouch(0, 1));
  EXPECT_TRUE(filter.mayTouch(4, 1));
  EXPECT_TRUE(filter.mayTouch(2, 4));
}

TEST(ContactFilter, KeepsLinksOfAModelApartUnlessItAsks) {
  description::World world = crowd();
  {
    const world::Entities entities(world);
    EXPECT_FALSE(ContactFilter(entities).mayTouch(1, 3));
  }
  world.models[1].selfCollide = true;
  {
    const world::Entities entities(world);
    EXPECT_TRUE(ContactFilter(entities).mayTouch(1, 3));
    EXPECT_FALSE(ContactFilter(entities).mayTouch(1, 2)) << "a joint connects them";
  }
  world.models[1].links[2].selfCollide = false;
  {
    const world::Entities entities(world);
    EXPECT_FALSE(ContactFilter(entities).mayTouch(1, 3));
  }
}

TEST(ContactFilter, LeavesOutWhatNeverMoves) {
  description::World world = crowd();
  world.models[2].isStatic = true;
  world.models[1].links[0].kinematic = true;
  const world::Entities entities(world);
  const ContactFilter filter(entities);
  EXPECT_FALSE(filter.mayTouch(0, 4));
  EXPECT_FALSE(filter.mayTouch(1, 4));
  EXPECT_TRUE(filter.mayTouch(2, 4));
}

}  // namespace
}  // namespace pongsim::physics
