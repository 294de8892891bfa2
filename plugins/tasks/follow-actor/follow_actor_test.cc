#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/actor.hh"
#include "support/running_world.hh"

namespace pongsim::follow_actor_test {
namespace {

using test::RunningWorld;

constexpr const char* kTarget = "<target>box</target>";

std::string worldWith(const std::string& parameters, const std::string& animation = "<animation name='walk'/>") {
  return R"(<model name="box"><static>true</static><pose>3 4 0.5 0 0 0</pose><link name="l"/></model>
    <actor name="walker"><pose>0 0 1 0 0 0</pose>)" +
         animation +
         R"(<script><trajectory id="0" type="walk"><waypoint><time>0</time><pose>9 9 9 0 0 0</pose></waypoint>
      <waypoint><time>9</time><pose>8 8 8 0 0 0</pose></waypoint></trajectory></script>
      <plugin filename="ignition-gazebo-follow-actor-system" name="ignition::gazebo::systems::FollowActor">)" +
         parameters + "</plugin></actor>";
}

/// A world without what it says of movements, which are not shown.
class FollowActorTest : public testing::Test {
 protected:
  void start(const std::string& parameters) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(RunningWorld::textOf(worldWith(parameters)), "world.sdf", {}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
  }
  Pose walker() { return Actor::find(simulation_->world(), "walker")->pose(); }
  double distance() {
    return (simulation_->world().model("box")->pose().position - walker().position).head<2>().norm();
  }
  void moveBox(const Vector3& position) {
    EXPECT_TRUE(simulation_->world().model("box")->setPose({position, Quaternion::Identity()}));
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(FollowActorTest, WalksTowardsItsTargetUpToTheDistance) {
  start(std::string(kTarget) + "<max_distance>8</max_distance>");
  EXPECT_EQ(walker().position, Vector3(0, 0, 1));
  simulation_->step(1000);
  EXPECT_NEAR(distance(), 5 - 0.8, 1e-9);
  EXPECT_NEAR(walker().position.x(), 0.8 * 0.6, 1e-9);
  EXPECT_EQ(walker().position.z(), 1);
  EXPECT_NEAR(yawOf(walker().rotation), std::atan2(4, 3), 1e-9);
  simulation_->step(6000);
  EXPECT_NEAR(distance(), 1.2, 1e-3);
}

TEST_F(FollowActorTest, DoesNotFollowWhatIsTooFarAway) {
  start(kTarget);
  simulation_->step(1000);
  EXPECT_EQ(distance(), 5);
  moveBox({2, 0, 0});
  simulation_->step(500);
  EXPECT_NEAR(distance(), 1.6, 1e-9);
  moveBox({20, 0, 0});
  simulation_->step(500);
  EXPECT_NEAR(walker().position.x(), 0.4, 1e-9);
}

TEST_F(FollowActorTest, TakesItsOwnSpeedAndDistances) {
  start(std::string(kTarget) + "<velocity>2</velocity><min_distance>4</min_distance><max_distance>6</max_distance>");
  simulation_->step(100);
  EXPECT_NEAR(distance(), 4.8, 1e-9);
  simulation_->step(1000);
  EXPECT_NEAR(distance(), 4, 2e-3);
}

TEST_F(FollowActorTest, StaysWhereItsTargetIsGone) {
  start(std::string(kTarget) + "<max_distance>8</max_distance>");
  simulation_->step(100);
  EXPECT_TRUE(simulation_->remove(*simulation_->world().model("box")));
  const Vector3 there = walker().position;
  simulation_->step(100);
  EXPECT_EQ(walker().position, there);
}

TEST_F(FollowActorTest, BeginsAgainAfterAResetAndGoesOnFromASavedState) {
  start(std::string(kTarget) + "<max_distance>8</max_distance>");
  simulation_->step(500);
  const std::vector<std::byte> state = simulation_->saveState();
  const Vector3 there = walker().position;
  simulation_->step(500);
  const Vector3 later = walker().position;
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(walker().position, Vector3(0, 0, 1));
  EXPECT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(walker().position, there);
  simulation_->step(500);
  EXPECT_EQ(walker().position, later);
}

TEST_F(FollowActorTest, FollowsAnotherActor) {
  Diagnostics diagnostics;
  simulation_ = Simulation::fromText(RunningWorld::textOf("<actor name='first'><pose>3 0 0 0 0 0</pose></actor>" +
                                                          worldWith("<target>first</target>")),
                                     "world.sdf", {}, diagnostics);
  ASSERT_NE(simulation_, nullptr);
  simulation_->step(1000);
  EXPECT_NEAR(walker().position.x(), 0.8, 1e-9);
}

/// @return What is said of the system.
std::string complaintAbout(const std::string& world) {
  std::string found;
  for (const std::string& complaint : RunningWorld::complaintsAbout(world)) {
    if (complaint.find("filename") == std::string::npos) found = complaint;
  }
  return found;
}

TEST(FollowActor, SaysWhatIsWrong) {
  const std::string left = "follow-actor of walker is left out: ";
  EXPECT_EQ(complaintAbout(worldWith("")), left + "no <target> is given");
  EXPECT_EQ(complaintAbout(worldWith("<target>bx</target>")),
            left + "<target> 'bx' is not a model or actor of the world");
  EXPECT_EQ(complaintAbout(worldWith("<target>walker</target>")), left + "<target> 'walker' is the actor itself");
  EXPECT_EQ(complaintAbout(worldWith(kTarget, "")), "");
  EXPECT_EQ(complaintAbout(worldWith(std::string(kTarget) + "<animation>run</animation>")),
            "actor 'walker' has no <animation> 'run' to show");
  EXPECT_EQ(complaintAbout(R"(<plugin filename="ignition-gazebo-follow-actor-system"
                                      name="ignition::gazebo::systems::FollowActor"/>)"),
            "follow-actor is left out: it belongs in an <actor>");
}

}  // namespace
}  // namespace pongsim::follow_actor_test
