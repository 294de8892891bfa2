#include "urdf/origin.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

Pose poseIn(std::string_view origin) {
  const Element robot = robotWith(std::string(origin));
  return originOf(robot);
}

TEST(Origin, IsWhereThePartLies) {
  const Pose pose = poseIn("<origin xyz='1 -2 3e-1' rpy='0.1 0.2 -0.3'/>");
  EXPECT_EQ(pose.position, Vector3(1, -2, 0.3));
  EXPECT_EQ(pose.rotation.coeffs(), fromRollPitchYaw(0.1, 0.2, -0.3).coeffs());
}

TEST(Origin, IsNeitherMovedNorTurnedWhereNothingIsSaid) {
  EXPECT_EQ(poseIn(""), Pose());
  EXPECT_EQ(poseIn("<origin/>"), Pose());
  EXPECT_EQ(poseIn("<origin xyz='0 0 1'/>").rotation.coeffs(), Pose().rotation.coeffs());
}

}  // namespace
}  // namespace pongsim::urdf::test
