#include "web/frames/roster.hh"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::web {
namespace {

using pongsim::test::RunningWorld;

TEST(Roster, TellsWhereModelsLinksAndActorsAreAtAllDepths) {
  RunningWorld world(std::string(R"(
    <model name="cart"><pose>1 2 3 0 0 1</pose>
      <link name="base"><pose>0 0 0.5 0 0 0</pose></link>
      <link name="mast"><pose>0 0 1 0.5 0 0</pose></link>
      <joint name="hold" type="fixed"><parent>base</parent><child>mast</child></joint>
      <model name="box"><pose>0 1 0 0 0 0</pose><link name="lid"/></model>
    </model>
    <actor name="walker"><pose>0 0 1 0 0 0</pose><link name="l"/><script><loop>false</loop>
      <trajectory id="0" type="walk" tension="1">
        <waypoint><time>0</time><pose>0 0 0 0 0 0</pose></waypoint>
        <waypoint><time>0.1</time><pose>2 0 0 0 0 0</pose></waypoint>
      </trajectory></script></actor>
    <model name="wall"><static>true</static><pose>0 5 0 0 0 0</pose><link name="bricks"/></model>)"));
  const World simulated = world.simulation().world();
  const Roster roster(simulated);
  world.step(100);

  std::vector<Pose> X_WorldLinks;
  for (const Link& link : roster.links()) X_WorldLinks.push_back(link.pose());
  std::vector<Pose> X_WorldActors;
  for (const Actor& actor : roster.actors()) X_WorldActors.push_back(actor.pose());
  std::vector<FramePose> poses;
  roster.poses(X_WorldLinks, X_WorldActors, poses);

  std::map<std::uint64_t, Pose> expected;
  for (const char* name : {"cart", "cart::box", "wall"}) {
    const Model model = simulated.model(name).value();
    expected[model.id().value] = model.pose();
    for (const Link& link : model.links()) expected[link.id().value] = link.pose();
  }
  const Actor walker = Actor::find(simulated, "walker").value();
  expected[walker.id().value] = walker.pose();
  EXPECT_NEAR(walker.pose().position.x(), 2, 1e-5);
  ASSERT_EQ(poses.size(), expected.size());
  for (const FramePose& each : poses) {
    ASSERT_TRUE(expected.contains(each.entity));
    const Pose& pose = expected[each.entity];
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(each.pose[static_cast<std::size_t>(axis)], pose.position[axis], 1e-5) << each.entity;
    EXPECT_NEAR(each.pose[3], pose.rotation.x(), 1e-5);
    EXPECT_NEAR(each.pose[5], pose.rotation.z(), 1e-5);
    EXPECT_NEAR(each.pose[6], pose.rotation.w(), 1e-5);
  }
}

}  // namespace
}  // namespace pongsim::web
