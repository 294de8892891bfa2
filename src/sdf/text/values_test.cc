#include <numbers>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

/// Loads a link with this pose, which begins in line 4.
Loaded loadPose(const std::string& pose) { return loadModel("<link name='l'>\n" + pose + "</link>"); }

Pose poseOf(const std::string& pose) {
  const Loaded loaded = loadPose(pose);
  EXPECT_EQ(loaded.messages, Messages());
  return loaded.model().links.at(0).X_ModelLink;
}

TEST(Values, ReadPosesInAllFormats) {
  const double half = std::numbers::pi / 2;
  expectPose(poseOf(""), {0, 0, 0});
  expectPose(poseOf("<pose/>"), {0, 0, 0});
  expectPose(poseOf("<pose>\n 1 2\t3 0.1 0.2 0.3 </pose>"), {1, 2, 3}, fromRollPitchYaw(0.1, 0.2, 0.3));
  expectPose(poseOf("<pose degrees='true'>1 2 3 0 0 90</pose>"), {1, 2, 3}, fromRollPitchYaw(0, 0, half));
  expectPose(poseOf("<pose rotation_format='quat_xyzw'>1 2 3 0 0 2 2</pose>"), {1, 2, 3}, fromRollPitchYaw(0, 0, half));
  expectPose(poseOf("<pose rotation_format='euler_rpy'>1 2 3 0 0 0</pose>"), {1, 2, 3});
}

TEST(Values, RefusePosesThatAreNone) {
  const auto message = [](const std::string& pose) { return loadPose(pose).messages; };
  const std::string six = ", which is not a pose: six finite numbers, x y z roll pitch yaw";
  EXPECT_EQ(message("<pose>1 2 3 x 0 0</pose>"), Messages{"t.sdf:4:1: error: <pose> is '1 2 3 x 0 0'" + six});
  EXPECT_EQ(message("<pose>1 2 nan 0 0 0</pose>"), Messages{"t.sdf:4:1: error: <pose> is '1 2 nan 0 0 0'" + six});
  EXPECT_EQ(
      message("<pose rotation_format='quat_xyzw'>0 0 0 0 0 0 0</pose>"),
      Messages{"t.sdf:4:1: error: <pose> is '0 0 0 0 0 0 0', which is not a pose: its quaternion has length zero"});
  EXPECT_EQ(
      message("<pose>0 1e308 0 0 0 0</pose>"),
      Messages{"t.sdf:4:1: error: <pose> is '0 1e308 0 0 0 0', which is not a position within 1e9 m of the origin"});
  EXPECT_EQ(
      message("<pose rotation_format='quat_xyzw'>0 0 -1e10 0 0 0 1</pose>"),
      Messages{"t.sdf:4:1: error: <pose> is '0 0 -1e10 0 0 0 1', which is not a position within 1e9 m of the origin"});
  EXPECT_EQ(message("<pose rotation_format='quat'/>"), Messages());
  EXPECT_EQ(
      message("<pose rotation_format='quat'>0</pose>"),
      Messages{"t.sdf:4:7: error: attribute 'rotation_format' is 'quat', which is not 'euler_rpy' or 'quat_xyzw'"});
  EXPECT_EQ(message("<pose degrees='si'>0 0 0 0 0 0</pose>"),
            Messages{"t.sdf:4:7: error: attribute 'degrees' is 'si', which is not 'true' or 'false'"});
}

TEST(Values, WarnOfPosesOfAnotherLength) {
  const Loaded loaded = loadPose("<pose>1 2 3</pose>");
  EXPECT_EQ(
      loaded.messages,
      Messages{
          "t.sdf:4:1: warning: <pose> has 3 numbers instead of six: x y z roll pitch yaw | missing ones are zero"});
  expectPose(loaded.model().links.at(0).X_ModelLink, {1, 2, 3});
}

TEST(Values, RefuseFlagsThatAreNone) {
  EXPECT_EQ(loadLink("<gravity>maybe</gravity>").messages,
            Messages{"t.sdf:4:1: error: <gravity> is 'maybe', which is not 'true' or 'false'"});
}

TEST(Values, QuoteLongTextsInPart) {
  const Loaded loaded = loadLink("<inertial><mass>" + std::string(10'000, 'x') + "</mass></inertial>");
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_LT(loaded.messages[0].size(), 200U);
}

}  // namespace
}  // namespace pongsim::sdf::test
