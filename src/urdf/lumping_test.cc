#include "urdf/lumping.hh"

#include <cmath>

#include "support/urdf/robot_support.hh"
#include "urdf/urdfdom.hh"

namespace pongsim::urdf::test {
namespace {

struct LumpedRobot {
  explicit LumpedRobot(std::string_view content) : xml(robotWith(content)) {
    Diagnostics diagnostics;
    robot = robotFrom(*readWithUrdfdom(xml, diagnostics), xml);
    lumpFixedJoints(robot, Extensions(xml));
  }
  const Link& link(std::string_view name) const {
    for (const Link& link : robot.links) {
      if (link.name == name) return link;
    }
    throw std::out_of_range(std::string(name));
  }
  Element xml;
  Robot robot;
};

TEST(Lumping, CombinesMassesAndInertias) {
  // two equal masses, one turned by a quarter about z and 2 m away along x
  const std::string mass =
      "<inertial><mass value='3'/><inertia ixx='0.1' ixy='0' ixz='0' iyy='0.2' iyz='0' izz='0.3'/></inertial>";
  const LumpedRobot robot("<link name='a'>" + mass + "</link><link name='b'>" + mass + "</link>" +
                          jointNamed("j", "fixed", "a", "b", "<origin xyz='2 0 0' rpy='0 0 1.5707963267948966'/>"));
  const Inertial& inertial = robot.link("a").inertial.value();
  EXPECT_EQ(inertial.mass, 6);
  EXPECT_TRUE(inertial.com.isApprox(Vector3(1, 0, 0), 1e-12));
  // each mass is 1 m off the common centre: 3 kg m^2 each about y and z
  EXPECT_TRUE(inertial.moments.isApprox(Matrix3(Vector3(0.1 + 0.2, 0.2 + 0.1 + 6, 0.3 + 0.3 + 6).asDiagonal()), 1e-12))
      << inertial.moments;
}

TEST(Lumping, GivesAParentWithoutMassThatOfItsChild) {
  const LumpedRobot robot("<link name='a'/>" + linkNamed("b") +
                          jointNamed("j", "fixed", "a", "b", "<origin xyz='0 0 1'/>"));
  EXPECT_EQ(robot.link("a").inertial.value().mass, 1);
  EXPECT_EQ(robot.link("a").inertial->com, Vector3(0, 0, 1));
}

TEST(Lumping, HangsJointsFurtherDownOnTheLinkThatStays) {
  const LumpedRobot robot(linkNamed("a") + linkNamed("b") + linkNamed("c") + linkNamed("d") +
                          jointNamed("j", "fixed", "a", "b", "<origin xyz='1 0 0'/>") +
                          jointNamed("k", "fixed", "b", "c", "<origin xyz='0 1 0'/>") +
                          jointNamed("l", "continuous", "c", "d", "<origin xyz='0 0 1'/>"));
  EXPECT_EQ(robot.link("c").lumpedInto.value().link, 0U);
  EXPECT_EQ(robot.link("c").lumpedInto->X_TargetLink.position, Vector3(1, 1, 0));
  EXPECT_EQ(robot.link("d").joint->parent, 0U);
  EXPECT_EQ(robot.link("d").joint->X_ParentJoint.position, Vector3(1, 1, 1));
  EXPECT_EQ(robot.link("a").lumped.size(), 2U);
  EXPECT_EQ(robot.link("a").inertial->mass, 3);
}

TEST(Lumping, LeavesWhatIsKeptAndWhatIsFixedToTheWorld) {
  const LumpedRobot kept(linkNamed("a") + linkNamed("b") + jointNamed("j", "fixed", "a", "b") +
                         "<gazebo reference='j'><preserveFixedJoint>true</preserveFixedJoint></gazebo>");
  EXPECT_FALSE(kept.link("b").lumpedInto);
  const LumpedRobot world("<link name='world'/>" + linkNamed("b") + jointNamed("j", "fixed", "world", "b"));
  EXPECT_FALSE(world.link("b").lumpedInto);
}

}  // namespace
}  // namespace pongsim::urdf::test
