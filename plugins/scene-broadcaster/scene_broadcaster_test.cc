#include <gtest/gtest.h>
#include <ignition/msgs/pose_v.pb.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim::scene_broadcaster_test {
namespace {

std::string world(const std::string& plugins) {
  return R"(<sdf version="1.9"><world name="drop test">)" + plugins + R"(
    <model name="floor"><static>true</static><link name="slab"/></model>
    <model name="ball"><pose>0 1 2 0 0 1.5707963267948966</pose>
      <link name="skin"><pose>0.5 0 0 0 0 0</pose><inertial><mass>1</mass></inertial></link>
    </model>
  </world></sdf>)";
}

std::string broadcaster(const std::string& parameters) {
  return R"(<plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
            <plugin filename="ignition-gazebo-scene-broadcaster-system"
                    name="ignition::gazebo::systems::SceneBroadcaster">)" +
         parameters + "</plugin>";
}

class SceneBroadcasterTest : public testing::Test {
 protected:
  void start(const std::string& text) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(text, "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    const auto listen = [this](const std::string& topic, std::vector<ignition::msgs::Pose_V>& into) {
      return simulation_->transport().node().subscribe<ignition::msgs::Pose_V>(
          topic, [&into](const auto& message) { into.push_back(message); });
    };
    allSubscription_ = listen("/world/drop_test/pose/info", all_);
    movingSubscription_ = listen("/world/drop_test/dynamic_pose/info", moving_);
  }

  std::unique_ptr<Simulation> simulation_;
  std::vector<ignition::msgs::Pose_V> all_;
  std::vector<ignition::msgs::Pose_V> moving_;
  Subscription allSubscription_;
  Subscription movingSubscription_;
};

TEST_F(SceneBroadcasterTest, TellsModelsInTheWorldAndLinksInTheirModel) {
  start(world(broadcaster("")));
  simulation_->step(2);
  ASSERT_EQ(moving_.size(), 1U);
  ASSERT_EQ(moving_[0].pose_size(), 2);
  EXPECT_EQ(moving_[0].header().stamp().nsec(), 1'000'000);
  const ignition::msgs::Pose& model = moving_[0].pose(0);
  EXPECT_EQ(model.name(), "ball");
  EXPECT_EQ(model.id(), simulation_->world().model("ball")->id().value);
  EXPECT_NEAR(model.position().y(), 1, 1e-9);
  EXPECT_NEAR(model.position().z(), 2, 1e-4);
  EXPECT_NEAR(model.orientation().z(), std::sqrt(0.5), 1e-9);
  const ignition::msgs::Pose& link = moving_[0].pose(1);
  EXPECT_EQ(link.name(), "skin");
  EXPECT_NEAR(link.position().x(), 0.5, 1e-9);
  EXPECT_NEAR(link.position().y(), 0, 1e-9);
  EXPECT_NEAR(link.orientation().w(), 1, 1e-9);
}

TEST_F(SceneBroadcasterTest, TellsWhatIsStaticOnPoseInfoOnly) {
  start(world(broadcaster("")));
  simulation_->step(2);
  ASSERT_EQ(all_.size(), 1U);
  std::vector<std::string> names;
  for (const ignition::msgs::Pose& pose : all_[0].pose()) names.push_back(pose.name());
  EXPECT_EQ(names, (std::vector<std::string>{"floor", "ball", "slab", "skin"}));
}

TEST_F(SceneBroadcasterTest, KeepsItsRateInSimulatedTime) {
  start(world(broadcaster("<dynamic_pose_hertz>30</dynamic_pose_hertz>")));
  simulation_->step(2001);
  EXPECT_NEAR(static_cast<double>(moving_.size()), 60, 1);
}

TEST_F(SceneBroadcasterTest, IsThereInAWorldThatListsNoSystem) {
  start(world(""));
  simulation_->step(2);
  EXPECT_EQ(moving_.size(), 1U);
}

TEST_F(SceneBroadcasterTest, SpeaksWhilePaused) {
  start(world(broadcaster("")));
  simulation_->stepPaused();
  simulation_->stepPaused();
  ASSERT_EQ(moving_.size(), 1U);
  EXPECT_EQ(moving_[0].pose(0).position().z(), 2);
}

TEST(SceneBroadcasterParameters, RefusesARateOfZero) {
  Diagnostics diagnostics;
  Simulation::fromText(world(broadcaster("<dynamic_pose_hertz>0</dynamic_pose_hertz>")), "world.sdf", {}, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message,
            "scene-broadcaster is left out: <dynamic_pose_hertz> must be a number above zero");
}

}  // namespace
}  // namespace pongsim::scene_broadcaster_test
