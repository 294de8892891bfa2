#include "urdf/robot.hh"

#include "support/urdf/robot_support.hh"
#include "urdf/urdfdom.hh"

namespace pongsim::urdf::test {
namespace {

TEST(Robot, HasItsLinksFromTheRootDown) {
  const Element xml = robotWith(linkNamed("c") + linkNamed("b") + linkNamed("a") + jointNamed("j2", "fixed", "a", "b") +
                                jointNamed("j1", "continuous", "a", "c", "<origin xyz='1 2 3'/>"));
  Diagnostics diagnostics;
  const Robot robot = robotFrom(*readWithUrdfdom(xml, diagnostics), xml);
  ASSERT_EQ(robot.links.size(), 3U);
  EXPECT_EQ(robot.links[0].name, "a");
  EXPECT_EQ(robot.links[1].name, "c");
  EXPECT_EQ(robot.links[2].name, "b");
  EXPECT_FALSE(robot.links[0].joint);
  EXPECT_EQ(robot.links[1].joint->X_ParentJoint.position, Vector3(1, 2, 3));
  EXPECT_EQ(robot.links[1].xml->position.line, 2);
  EXPECT_EQ(robot.links[1].joint->xml->position.line, 6);
}

TEST(Robot, HasInertiaAlongTheAxesOfTheLink) {
  const Element xml = robotWith(
      "<link name='a'><inertial><origin xyz='0 0 1' rpy='0 0 1.5707963267948966'/><mass value='2'/>"
      "<inertia ixx='1' ixy='0' ixz='0' iyy='2' iyz='0' izz='3'/></inertial></link>");
  Diagnostics diagnostics;
  const Robot robot = robotFrom(*readWithUrdfdom(xml, diagnostics), xml);
  const Inertial& inertial = robot.links.at(0).inertial.value();
  EXPECT_EQ(inertial.mass, 2);
  EXPECT_EQ(inertial.com, Vector3(0, 0, 1));
  EXPECT_TRUE(inertial.moments.isApprox(Matrix3(Vector3(2, 1, 3).asDiagonal()), 1e-12)) << inertial.moments;
}

}  // namespace
}  // namespace pongsim::urdf::test
