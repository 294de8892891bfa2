#include "msgs/state/component.hh"

#include <gtest/gtest.h>

namespace pongsim::msgs {
namespace {

TEST(Component, HasTheNumberOfItsFullName) {
  // FNV-1a with 64 bits of "ign_gazebo_components.Name"
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : std::string("ign_gazebo_components.Name")) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  EXPECT_EQ(componentType("Name"), hash);
  EXPECT_NE(componentType("Name"), componentType("Pose"));
}

TEST(Component, KeepsEveryDigitOfAPose) {
  const Pose pose{{1.0 / 3, -2e-17, 1e300}, fromRollPitchYaw(0.1, -0.2, 0.3)};
  const std::optional<Pose> read = poseOfComponent(componentText(pose));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->position, pose.position);
  EXPECT_NEAR(read->rotation.angularDistance(pose.rotation), 0, 1e-14);
}

TEST(Component, IsNoPoseWhereSomethingElseStands) {
  for (const char* text : {"", "1 2 3 4 5", "1 2 3 4 5 6 7", "1 2 3 a 5 6"})
    EXPECT_FALSE(poseOfComponent(text)) << text;
}

TEST(Component, NumbersTypesOfJointsAsFortressDoes) {
  EXPECT_EQ(jointTypeNumber("ball"), 1);
  EXPECT_EQ(jointTypeNumber("revolute"), 6);
  EXPECT_EQ(jointTypeNumber("hinge"), 0);
  EXPECT_EQ(jointTypeOfNumber(9), "universal");
  EXPECT_EQ(jointTypeOfNumber(0), "");
  EXPECT_EQ(jointTypeOfNumber(10), "");
}

TEST(Component, NamesTheOneOfASensorsType) {
  EXPECT_EQ(sensorComponent("air_pressure"), "AirPressureSensor");
  EXPECT_EQ(sensorComponent("segmentation_camera"), "SegmentationCamera");
  EXPECT_EQ(sensorComponent("boundingbox_camera"), "BoundingBoxCamera");
  EXPECT_EQ(sensorComponent("contact"), "");
}

}  // namespace
}  // namespace pongsim::msgs
