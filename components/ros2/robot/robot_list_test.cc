#include "ros2/robot/robot_list.hh"

#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

using test::inWorld;
using test::worldOf;
using Words = std::vector<std::string>;

constexpr const char* kBox = "<model name='box'><link name='l'/></model>";
constexpr const char* kCart =
    "<model name='cart'><link name='base'/><link name='wheel'/><joint name='j' type='revolute'><parent>base</parent>"
    "<child>wheel</child><axis><xyz>0 0 1</xyz></axis></joint></model>";

std::string drone(const std::string& name) {
  return "<model name='" + name +
         "'><link name='body'><sensor name='eye' type='camera'><pose>1 0 0 0 0 0</pose><camera>"
         "<optical_frame_id>lens</optical_frame_id></camera></sensor></link></model>";
}

Words namesOf(const RobotList& list) {
  Words names;
  for (const Robot& robot : list.robots()) names.push_back(robot.name);
  return names;
}

TEST(RobotList, TakesForARobotWhatCanMoveAndHasAJointOrASystemOrASensor) {
  const auto simulation =
      worldOf(inWorld(kBox + std::string(kCart) + drone("drone") +
                      "<model name='driven'><link name='l'/><plugin filename='ignition-gazebo-velocity-control-system' "
                      "name='ignition::gazebo::systems::VelocityControl'/></model>"
                      "<model name='post'><static>true</static><link name='l'/><plugin filename='a' name='b'/></model>"
                      "<model name='outer'><link name='l'/>" +
                      std::string(kCart) + "</model>"));
  RobotList list(simulation->world(), {}, {});
  EXPECT_TRUE(list.update());
  EXPECT_EQ(namesOf(list), (Words{"cart", "drone", "driven", "outer"}));
  EXPECT_FALSE(list.update());
}

TEST(RobotList, TakesThoseThatAreNamedWhereSomeAre) {
  const auto simulation = worldOf(inWorld(kBox + std::string(kCart)));
  RobotSettings settings;
  settings.robots = {"box"};
  RobotList list(simulation->world(), {}, settings);
  EXPECT_TRUE(list.update());
  EXPECT_EQ(namesOf(list), Words{"box"});
}

TEST(RobotList, FollowsWhatComesAndGoes) {
  const auto simulation = worldOf(inWorld(kCart));
  RobotList list(simulation->world(), {}, {});
  EXPECT_TRUE(list.update());
  Diagnostics diagnostics;
  const auto drone2 = simulation->insertText("<sdf version='1.9'>" + drone("drone") + "</sdf>", "t", {}, diagnostics);
  ASSERT_TRUE(drone2);
  EXPECT_TRUE(list.update());
  EXPECT_EQ(namesOf(list), (Words{"cart", "drone"}));
  ASSERT_TRUE(simulation->remove(simulation->world().model("cart").value()));
  EXPECT_TRUE(list.update());
  EXPECT_EQ(namesOf(list), Words{"drone"});
}

TEST(RobotList, KnowsTheFramesOfSensors) {
  const auto simulation =
      worldOf(inWorld(drone("drone") + "<model name='wall'><static>true</static><pose>0 0 2 0 0 0</pose><link name='l'>"
                                       "<pose>1 0 0 0 0 0</pose><sensor name='s' type='imu'/></link></model>"));
  RobotList list(simulation->world(), {.prefix = "p/"}, {});
  ASSERT_TRUE(list.update());
  ASSERT_EQ(list.robots().size(), 1U);
  const std::vector<SensorFrame>& eyes = list.robots().front().sensors;
  ASSERT_EQ(eyes.size(), 2U);
  EXPECT_EQ(eyes[0].frame, "p/drone/body/eye");
  EXPECT_EQ(eyes[0].parent, "p/drone/body");
  EXPECT_EQ(eyes[0].X_ParentSensor.position, Vector3(1, 0, 0));
  EXPECT_EQ(eyes[1].frame, "p/lens");
  // what the camera looks at is along z of the optical frame
  EXPECT_LE((eyes[1].X_ParentSensor * Vector3(0, 0, 1) - Vector3(2, 0, 0)).norm(), 1e-12);

  ASSERT_EQ(list.fixtures().size(), 1U);
  const std::vector<SensorFrame>& frames = list.fixtures().front().frames;
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].frame, "p/wall/l");
  EXPECT_EQ(frames[0].parent, "p/world");
  EXPECT_EQ(frames[0].X_ParentSensor.position, Vector3(1, 0, 2));
  EXPECT_EQ(frames[1].frame, "p/wall/l/s");
  EXPECT_EQ(frames[1].parent, "p/wall/l");
}

TEST(RobotList, KeepsTheFramesOfTwoUrdfsApart) {
  const std::string urdf =
      "<robot name='NAME'><link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
      "ixz='0' "
      "iyz='0'/></inertial></link><gazebo><plugin filename='a' name='b'/></gazebo></robot>";
  const auto simulation = worldOf(inWorld(""));
  for (const char* name : {"one", "two"}) {
    std::string text = urdf;
    text.replace(text.find("NAME"), 4, name);
    Diagnostics diagnostics;
    ASSERT_TRUE(simulation->insertText(text, "t", {}, diagnostics));
  }
  RobotList list(simulation->world(), {}, {});
  testing::internal::CaptureStderr();
  ASSERT_TRUE(list.update());
  EXPECT_NE(testing::internal::GetCapturedStderr().find("robot 'two' shares frame names with another robot"),
            std::string::npos);
  EXPECT_EQ(list.robots().front().tree.links.at(0).frame, "base");
  EXPECT_EQ(list.robots().back().tree.links.at(0).frame, "two/base");
}

}  // namespace
}  // namespace pongsim::ros2
