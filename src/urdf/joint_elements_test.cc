#include "urdf/joint_elements.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

/// @param content Content of the joint.
/// @param more Further content of the robot.
/// @return A robot with a joint "j" of this type between links "a" and "b".
Converted joint(const std::string& type, const std::string& content, const std::string& more = "") {
  return convert(linkNamed("a") + linkNamed("b") + jointNamed("j", type, "a", "b", content) + more);
}

TEST(JointElements, HaveLimitsAndDynamics) {
  const Converted converted =
      joint("revolute",
            "<origin xyz='1 2 3'/><axis xyz='0 1 0'/><limit lower='-1' upper='2' effort='3' velocity='4'/>"
            "<dynamics damping='0.1' friction='0.2'/><safety_controller k_velocity='10' soft_lower_limit='-0.5'/>");
  EXPECT_EQ(converted.messages, Messages());
  const Element& element = converted.part("joint", "j");
  EXPECT_EQ(element.attributeOr("type", ""), "revolute");
  EXPECT_EQ(textAt(element, "parent"), "a");
  EXPECT_EQ(textAt(element, "child"), "b");
  EXPECT_EQ(textAt(element, "pose"), "1 2 3 0 0 0");
  EXPECT_EQ(element.child("pose")->attributeOr("relative_to", ""), "a");
  EXPECT_EQ(textAt(element, "axis/xyz"), "0 1 0");
  EXPECT_EQ(textAt(element, "axis/limit/lower"), "-1");
  EXPECT_EQ(textAt(element, "axis/limit/upper"), "2");
  EXPECT_EQ(textAt(element, "axis/limit/effort"), "3");
  EXPECT_EQ(textAt(element, "axis/limit/velocity"), "4");
  EXPECT_EQ(textAt(element, "axis/dynamics/damping"), "0.1");
  EXPECT_EQ(textAt(element, "axis/dynamics/friction"), "0.2");
  EXPECT_EQ(converted.part("link", "b").child("pose")->attributeOr("relative_to", ""), "j");
}

TEST(JointElements, TurnWithoutEndWhereTheyAreContinuous) {
  const Converted converted = joint("continuous", "<limit lower='-1' upper='2' effort='3' velocity='4'/>");
  const Element& element = converted.part("joint", "j");
  EXPECT_EQ(element.attributeOr("type", ""), "revolute");
  EXPECT_EQ(textAt(element, "axis/xyz"), "1 0 0");
  EXPECT_EQ(textAt(element, "axis/limit/lower"), "(none)");
  EXPECT_EQ(textAt(element, "axis/limit/effort"), "3");
  EXPECT_NE(element.child("axis")->child("dynamics"), nullptr);
}

TEST(JointElements, SwapLimitsThatAreTheWrongWayRound) {
  const Converted converted = joint("prismatic", "<limit lower='2' upper='1' effort='3' velocity='4'/>");
  EXPECT_EQ(converted.messages, Messages{"r.urdf:4:69: warning: the lower limit of joint 'j' is above its upper limit "
                                         "| they are swapped, as in Fortress"});
  EXPECT_EQ(textAt(converted.part("joint", "j"), "axis/limit/lower"), "1");
  EXPECT_EQ(textAt(converted.part("joint", "j"), "axis/limit/upper"), "2");
}

TEST(JointElements, LeaveALinkFreeThatFloats) {
  const Converted converted = joint("floating", "<origin xyz='1 2 3'/>");
  EXPECT_EQ(converted.messages, Messages());
  EXPECT_FALSE(converted.has("joint", "j"));
  EXPECT_EQ(textAt(converted.part("link", "b"), "pose"), "1 2 3 0 0 0");
  EXPECT_EQ(converted.part("link", "b").child("pose")->attributeOr("relative_to", ""), "a");
  EXPECT_EQ(joint("planar", "").messages,
            Messages{"r.urdf:4:1: warning: joint 'j' is planar, which is not simulated: its child moves freely"});
}

TEST(JointElements, MimicAnother) {
  const Converted converted = joint("continuous", "<mimic joint='other' multiplier='2' offset='0.5'/>");
  EXPECT_EQ(converted.messages, Messages());
  const Element* mimic = converted.model().child("joint")->child("axis")->child("mimic");
  ASSERT_NE(mimic, nullptr);
  EXPECT_EQ(mimic->attributeOr("joint", ""), "other");
  EXPECT_EQ(textAt(*mimic, "multiplier"), "2");
  EXPECT_EQ(textAt(*mimic, "offset"), "0.5");
}

TEST(JointElements, KeepFixedJointsInTwoWays) {
  const Converted kept =
      joint("fixed", "", "<gazebo reference='j'><preserveFixedJoint>true</preserveFixedJoint></gazebo>");
  EXPECT_EQ(kept.part("joint", "j").attributeOr("type", ""), "fixed");
  EXPECT_EQ(kept.part("joint", "j").child("axis"), nullptr);
  const Converted locked =
      joint("fixed", "", "<gazebo reference='j'><disableFixedJointLumping>1</disableFixedJointLumping></gazebo>");
  EXPECT_EQ(locked.part("joint", "j").attributeOr("type", ""), "revolute");
  EXPECT_EQ(textAt(locked.part("joint", "j"), "axis/limit/lower"), "0");
  EXPECT_EQ(textAt(locked.part("joint", "j"), "axis/limit/upper"), "0");
}

TEST(JointElements, TieTheRobotToTheWorld) {
  const Converted converted = convert("<link name='world'/>" + linkNamed("a") +
                                      jointNamed("j", "fixed", "world", "a", "<origin xyz='0 0 1'/>"));
  EXPECT_EQ(converted.messages, Messages());
  EXPECT_EQ(textAt(converted.part("joint", "j"), "parent"), "world");
  EXPECT_EQ(converted.part("joint", "j").child("pose")->attributeOr("relative_to", ""), "__model__");
  EXPECT_FALSE(converted.has("link", "world"));
}

}  // namespace
}  // namespace pongsim::urdf::test
