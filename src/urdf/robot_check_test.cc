#include "urdf/robot_check.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

Messages check(std::string_view content) {
  Diagnostics diagnostics;
  const bool isSound = checkRobot(robotWith(content), diagnostics);
  EXPECT_NE(isSound, diagnostics.hasErrors());
  return messagesOf(diagnostics);
}

TEST(RobotCheck, PassesASoundRobotAndWhatUrdfDoesNotKnow) {
  EXPECT_EQ(check(linkNamed("a") + "<transmission><x/></transmission><ros2_control/><gazebo><zzz/></gazebo>"),
            Messages());
}

TEST(RobotCheck, NamesNumbersThatAreNone) {
  EXPECT_EQ(check("<link name='l'><inertial><mass value='heavy'/>\n"
                  "<inertia ixx='1' ixy='0' ixz='nan' iyy='1' iyz='0' izz='1'/></inertial>\n"
                  "<collision><origin xyz='0 0'/><geometry><sphere radius='1,5'/></geometry></collision></link>"),
            (Messages{
                "r.urdf:2:32: error: attribute 'value' of <mass> is 'heavy', which is not a finite number",
                "r.urdf:3:26: error: attribute 'ixz' of <inertia> is 'nan', which is not a finite number",
                "r.urdf:4:20: error: attribute 'xyz' of <origin> is '0 0', which is not 3 finite numbers",
                "r.urdf:4:49: error: attribute 'radius' of <sphere> is '1,5', which is not a finite number",
            }));
}

TEST(RobotCheck, NamesWhatIsMissing) {
  EXPECT_EQ(check("<link name='l'><inertial><mass/></inertial>\n<visual/><collision><geometry/></collision>\n"
                  "<visual><geometry><box/></geometry></visual></link>"),
            (Messages{
                "r.urdf:2:16: error: the <inertial> of link 'l' has no <inertia>",
                "r.urdf:2:26: error: <mass> of link 'l' has no attribute 'value'",
                "r.urdf:3:1: error: the <visual> of link 'l' has no <geometry>",
                "r.urdf:3:21: error: <geometry> of link 'l' has no shape",
                "r.urdf:4:19: error: <box> of link 'l' has no attribute 'size'",
            }));
}

TEST(RobotCheck, KnowsWhatAJointNeeds) {
  EXPECT_EQ(check("<joint name='a' type='hinge'><parent link='x'/><child link='y'/></joint>\n"
                  "<joint name='b' type='revolut'><parent link='x'/></joint>\n"
                  "<joint name='c' type='revolute'><parent link='x'/><child link='y'/></joint>\n"
                  "<joint name='d' type='prismatic'><parent link='x'/><child link='y'/><limit lower='1'/></joint>\n"
                  "<joint name='e'/>"),
            (Messages{
                "r.urdf:2:17: error: joint 'a' has the unknown type 'hinge' | the types are revolute, continuous, "
                "prismatic, fixed, floating and planar",
                "r.urdf:3:1: error: joint 'b' has no <child>",
                "r.urdf:3:17: error: joint 'b' has the unknown type 'revolut' | did you mean 'revolute'?",
                "r.urdf:4:1: error: joint 'c' is revolute and has no <limit> | for a joint without limits, use type "
                "'continuous'",
                "r.urdf:5:69: error: <limit> of joint 'd' has no attribute 'effort'",
                "r.urdf:5:69: error: <limit> of joint 'd' has no attribute 'velocity'",
                "r.urdf:6:1: error: joint 'e' has no attribute 'type'",
                "r.urdf:6:1: error: joint 'e' has no <parent>",
                "r.urdf:6:1: error: joint 'e' has no <child>",
            }));
}

TEST(RobotCheck, HelpsWithSpelling) {
  EXPECT_EQ(check("<link name='l'><colision/>\n<visual><geometry><spher radius='1'/></geometry></visual></link>\n"
                  "<jont/>\n<link name='m'><visual><geometry><mesh filname='a'/></geometry></visual></link>"),
            (Messages{
                "r.urdf:2:16: warning: <colision> is unknown in URDF: it is ignored | did you mean 'collision'?",
                "r.urdf:3:19: error: <spher> is not a shape of URDF | did you mean 'sphere'?",
                "r.urdf:4:1: warning: <jont> is unknown in URDF: it is ignored | did you mean 'joint'?",
                "r.urdf:5:34: error: <mesh> of link 'm' has no attribute 'filename' | it has 'filname'",
            }));
}

}  // namespace
}  // namespace pongsim::urdf::test
