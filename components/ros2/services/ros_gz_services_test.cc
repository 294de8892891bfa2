#include "ros2/services/ros_gz_services.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "ros2/types/ros_gz_interfaces.hh"
#include "ros2/types/simulation_entity_services.hh"
#include "support/ros2/served_world.hh"

namespace pongsim::ros2::ros_gz_services_test {
namespace {

namespace gz = ros_gz_interfaces;
using gz::srv::ControlWorld;
using gz::srv::DeleteEntity;
using gz::srv::SetEntityPose;
using gz::srv::SpawnEntity;
using simulation_interfaces::srv::GetEntities;
using simulation_interfaces::srv::GetEntityState;

const std::string kBox = "<sdf version='1.9'><model name='box'><static>true</static><link name='l'/></model></sdf>";

class RosGzServicesTest : public testing::Test {
 protected:
  bool control(const gz::WorldControl& what) { return world_.call<ControlWorld>("/world/w/control", {what}).success; }
  bool create(const gz::EntityFactory& what) { return world_.call<SpawnEntity>("/world/w/create", {what}).success; }
  bool remove(const gz::Entity& what) { return world_.call<DeleteEntity>("/world/w/remove", {what}).success; }
  bool setPose(const gz::Entity& what, const geometry_msgs::Pose& pose) {
    return world_.call<SetEntityPose>("/world/w/set_pose", {what, pose}).success;
  }
  simulation_interfaces::EntityState state(const std::string& entity) {
    return world_.call<GetEntityState>("/pongsim/get_entity_state", {entity}).state;
  }
  std::vector<std::string> entities() { return world_.call<GetEntities>("/pongsim/get_entities").entities; }
  static gz::Entity named(const std::string& name) { return {0, name, gz::Entity::kModel}; }

  ServedWorld world_{"<gravity>0 0 0</gravity><model name='ball'><pose>1 0 0 0 0 0</pose><link name='l'/></model>",
                     {"--paused"}};
};

using Names = std::vector<std::string>;

TEST_F(RosGzServicesTest, ControlTheWorld) {
  gz::WorldControl what;
  what.pause = true;
  what.multi_step = 5;
  EXPECT_TRUE(control(what));
  while (state("ball").header.stamp.nanosec < 5'000'000) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(state("ball").header.stamp.nanosec, 5'000'000U);
  what.multi_step = 0;
  what.reset.all = true;
  what.seed = 7;
  EXPECT_TRUE(control(what));
  EXPECT_EQ(state("ball").header.stamp.nanosec, 0U);
  what.reset = {};
  EXPECT_FALSE(control(what));
  what.seed = 0;
  what.reset.time_only = true;
  EXPECT_FALSE(control(what));
  EXPECT_TRUE(world_.process().waitForError("service '/world/w/control': .*a new seed needs a reset"));
}

TEST_F(RosGzServicesTest, RunUntilATime) {
  gz::WorldControl what;
  what.run_to_sim_time = {0, 20'000'000};
  EXPECT_TRUE(control(what));
  while (state("ball").header.stamp.nanosec < 20'000'000) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(state("ball").header.stamp.nanosec, 20'000'000U);
}

TEST_F(RosGzServicesTest, CreateEntities) {
  gz::EntityFactory what;
  what.sdf = kBox;
  what.name = "crate";
  what.pose.position = {1, 2, 3};
  EXPECT_TRUE(create(what));
  EXPECT_EQ(state("crate").pose.position.y, 2);
  EXPECT_FALSE(create(what));
  what.allow_renaming = true;
  what.relative_to = "ball";
  EXPECT_TRUE(create(what));
  EXPECT_EQ(state("crate_0").pose.position.x, 2);
  what = {};
  what.sdf_filename = world_.folder().write("box.sdf", kBox);
  EXPECT_TRUE(create(what));
  what = {};
  what.clone_name = "ball";
  what.name = "twin";
  EXPECT_TRUE(create(what));
  EXPECT_EQ(entities(), (Names{"ball", "crate", "crate_0", "box", "twin"}));
}

TEST_F(RosGzServicesTest, SayWhatTheyDoNotCreate) {
  gz::EntityFactory what;
  what.sdf = kBox;
  what.relative_to = "moon";
  EXPECT_FALSE(create(what));
  EXPECT_TRUE(world_.process().waitForError("service '/world/w/create': there is no frame 'moon'"));
  what.sdf.clear();
  what.relative_to = "world";
  EXPECT_FALSE(create(what));
  what.sdf = kBox;
  what.pose.position.x = std::nan("");
  EXPECT_FALSE(create(what));
  what.pose.position.x = 0;
  what.sdf = "nonsense";
  EXPECT_FALSE(create(what));
  EXPECT_EQ(entities(), Names{"ball"});
}

TEST_F(RosGzServicesTest, RemoveEntities) {
  EXPECT_FALSE(remove(named("bell")));
  EXPECT_TRUE(world_.process().waitForError("service '/world/w/remove': .*there is no model 'bell'"));
  EXPECT_FALSE(remove(named("")));
  EXPECT_TRUE(remove(named("ball")));
  EXPECT_EQ(entities(), Names{});
}

TEST_F(RosGzServicesTest, SetPoses) {
  geometry_msgs::Pose pose;
  pose.position = {4, 5, 6};
  EXPECT_TRUE(setPose(named("ball"), pose));
  EXPECT_EQ(state("ball").pose.position.z, 6);
  EXPECT_FALSE(setPose(named("bell"), pose));
  EXPECT_FALSE(setPose({1ULL << 40, "", gz::Entity::kModel}, pose));
  pose.position.x = std::nan("");
  EXPECT_FALSE(setPose(named("ball"), pose));
  EXPECT_EQ(state("ball").pose.position.x, 4);
}

}  // namespace
}  // namespace pongsim::ros2::ros_gz_services_test
