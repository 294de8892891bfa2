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
}

// slots: robot's body 0; of the payload nested in it, box 1, lid 2 and a loose stone 3
description::World carrier(const std::string& jointedLink) {
  description::Model payload =
      makeModel("payload", {makeLink("box", {0, 0, 0}, 1, {1, 1, 1}), makeLink("lid", {0, 0, 0}, 1, {1, 1, 1}),
                            makeLink("stone", {0, 0, 0}, 1, {1, 1, 1})});
  payload.joints.push_back(makeJoint("hinge", JointType::kBall, "box", "lid", Pose(), Pose()));
  description::Model robot = makeModel("robot", {makeLink("body", {0, 0, 0}, 1, {1, 1, 1})});
  robot.models = {payload};
  if (!jointedLink.empty()) {
    robot.joints.push_back(makeJoint("mount", JointType::kFixed, "body", jointedLink, Pose(), Pose()));
  }
  description::World world;
  world.models = {robot};
  return world;
}

TEST(ContactFilter, CountsWhatIsJointedToAModelToIt) {
  description::World world = carrier("payload::box");
  {
    const world::Entities entities(world);
    const ContactFilter filter(entities);
    EXPECT_FALSE(filter.mayTouch(0, 1));
    EXPECT_FALSE(filter.mayTouch(0, 2));
    EXPECT_TRUE(filter.mayTouch(0, 3)) << "nothing holds it";
    EXPECT_TRUE(filter.mayTouch(2, 3)) << "the lid belongs to the robot now, the stone to the payload";
  }
  // the model at the top decides
  world.models[0].models[0].selfCollide = true;
  {
    const world::Entities entities(world);
    EXPECT_FALSE(ContactFilter(entities).mayTouch(0, 2));
  }
  world.models[0].selfCollide = true;
  const world::Entities entities(world);
  EXPECT_TRUE(ContactFilter(entities).mayTouch(0, 2));
}

TEST(ContactFilter, LetsAModelTouchWhatIsOnlyNestedInIt) {
  const description::World world = carrier("");
  const world::Entities entities(world);
  const ContactFilter filter(entities);
  EXPECT_TRUE(filter.mayTouch(0, 2));
  EXPECT_FALSE(filter.mayTouch(2, 3));
}

TEST(ContactFilter, ReadsJointsThatGoRound) {
  description::World world = carrier("payload::box");
  world.models[0].joints.push_back(makeJoint("back", JointType::kBall, "payload::lid", "body", Pose(), Pose()));
  const world::Entities entities(world);
  EXPECT_FALSE(ContactFilter(entities).mayTouch(0, 2));
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
