#include <gtest/gtest.h>
#include <ignition/msgs/logical_camera_image.pb.h>

#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::logical_camera_test {
namespace {

using test::RunningWorld;

std::string box(const std::string& name, const std::string& pose, const std::string& inside = "") {
  return "<model name='" + name + "'><static>true</static><pose>" + pose + "</pose><link name='l'/>" + inside +
         "</model>";
}

// looks along y from 1 m high, 1 m wide and 0.5 m high at 1 m
constexpr const char* kCamera = R"(
  <plugin filename="ignition-gazebo-logical-camera-system" name="ignition::gazebo::systems::LogicalCamera"/>
  <model name="eye"><static>true</static><pose>0 0 1 0 0 1.5707963267948966</pose><link name="l">
    <sensor name="s" type="logical_camera"><topic>seen</topic><logical_camera><near>0.5</near><far>4</far>
      <aspect_ratio>2</aspect_ratio><horizontal_fov>0.9272952180016122</horizontal_fov></logical_camera></sensor>
  </link></model>)";

std::vector<std::string> namesSeen(const std::string& models) {
  RunningWorld world(kCamera + models);
  std::vector<ignition::msgs::LogicalCameraImage> messages;
  world.listen("/seen", messages);
  world.step(2);
  std::vector<std::string> names;
  for (const auto& model : messages.at(1).model()) names.push_back(model.name());
  return names;
}

TEST(LogicalCamera, SeesWhatStandsInItsPyramid) {
  EXPECT_EQ(namesSeen(box("far", "0 4.1 1 0 0 0") + box("near", "0 0.4 1 0 0 0") + box("behind", "0 -1 1 0 0 0") +
                      box("in", "0 2 1 0 0 0") + box("left", "-0.99 2 1 0 0 0") + box("too_left", "-1.01 2 1 0 0 0") +
                      box("high", "0 2 1.49 0 0 0") + box("too_high", "0 2 1.51 0 0 0")),
            (std::vector<std::string>{"high", "in", "left"}));
}

TEST(LogicalCamera, SeesNestedModelsByTheirOwnNames) {
  EXPECT_EQ(namesSeen(box("outer", "0 9 1 0 0 0", box("inner", "0 -7 0 0 0 0"))), std::vector<std::string>{"inner"});
}

TEST(LogicalCamera, TellsPosesInItsOwnFrame) {
  RunningWorld world(kCamera + box("b", "0.5 2 1 0 0 1.5707963267948966"));
  std::vector<ignition::msgs::LogicalCameraImage> messages;
  world.listen("/seen", messages);
  world.step(2);
  const ignition::msgs::LogicalCameraImage& image = messages.at(1);
  EXPECT_NEAR(image.pose().position().z(), 1, 1e-9);
  ASSERT_EQ(image.model_size(), 1);
  EXPECT_NEAR(image.model(0).pose().position().x(), 2, 1e-9);
  EXPECT_NEAR(image.model(0).pose().position().y(), -0.5, 1e-9);
  EXPECT_NEAR(image.model(0).pose().orientation().w(), 1, 1e-9);
  EXPECT_EQ(image.header().data(0).value(0), "eye::l::s");
}

TEST(LogicalCamera, OfFortressExampleSeesTheBox) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "examples/logical_camera_sensor.sdf");
  std::vector<ignition::msgs::LogicalCameraImage> messages;
  world.listen("/logical_camera", messages);
  world.step(200);
  ASSERT_FALSE(messages.empty());
  ASSERT_EQ(messages[0].model_size(), 1);
  EXPECT_EQ(messages[0].model(0).name(), "box");
}

}  // namespace
}  // namespace pongsim::logical_camera_test
