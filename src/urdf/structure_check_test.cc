#include "urdf/structure_check.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

Messages structureOf(std::string_view content) {
  Diagnostics diagnostics;
  const bool isSound = checkStructure(robotWith(content), diagnostics);
  EXPECT_NE(isSound, diagnostics.hasErrors());
  return messagesOf(diagnostics);
}

TEST(StructureCheck, PassesATree) {
  EXPECT_EQ(structureOf("<joint name='j'><parent link='a'/><child link='b'/></joint><link name='b'/><link name='a'/>"),
            Messages());
}

TEST(StructureCheck, NamesMissingAndRepeatedNames) {
  EXPECT_EQ(structureOf("<link/>\n<link name=''/>\n<joint/>\n<link name='a'/>\n<link name='a'/>"),
            (Messages{
                "r.urdf:2:1: error: a link has no name",
                "r.urdf:3:1: error: a link has no name",
                "r.urdf:4:1: error: a joint has no name",
                "r.urdf:6:1: error: there is a second link 'a'",
            }));
  EXPECT_EQ(structureOf(""), Messages{"r.urdf:1:1: error: the robot has no <link>"});
}

TEST(StructureCheck, NamesLinksThatAreNotThere) {
  EXPECT_EQ(structureOf("<link name='base_link'/><link name='b'/>\n"
                        "<joint name='j'><parent link='base_lnk'/><child/></joint>"),
            (Messages{
                "r.urdf:3:25: error: joint 'j' names parent link 'base_lnk', which does not exist | did you mean "
                "'base_link'?",
                "r.urdf:3:42: error: <child> of joint 'j' has no attribute 'link' | write <child link=\"...\"/>",
            }));
}

TEST(StructureCheck, WantsOneTree) {
  EXPECT_EQ(structureOf("<link name='a'/>\n<link name='b'/>"),
            Messages{"r.urdf:3:1: error: link 'b' has no parent joint, and neither has 'a' | a robot has one root: "
                     "every other link must be the child of a joint"});
  EXPECT_EQ(structureOf("<link name='a'/><link name='b'/><link name='c'/>" + jointNamed("j", "fixed", "a", "b") +
                        jointNamed("k", "fixed", "a", "c") + jointNamed("l", "fixed", "b", "c")),
            Messages{"r.urdf:4:48: error: joint 'l' has the child 'c', which is already the child of joint 'k' "
                     "| URDF does not support closed loops"});
}

TEST(StructureCheck, ShowsTheCircle) {
  EXPECT_EQ(structureOf("<link name='a'/><link name='b'/><link name='c'/><link name='d'/>\n" +
                        jointNamed("j", "fixed", "b", "c") + jointNamed("k", "fixed", "c", "b") +
                        jointNamed("l", "fixed", "c", "d")),
            Messages{"r.urdf:4:1: error: the joints form a loop: 'b' is below 'c', which is below 'b'"});
}

TEST(StructureCheck, BoundsTheNumberOfLinks) {
  std::string chain = "<link name='0'/>";
  for (int i = 1; i <= 5000; ++i) chain += "<link name='" + std::to_string(i) + "'/>";
  const Messages messages = structureOf(chain);
  ASSERT_FALSE(messages.empty());
  EXPECT_EQ(messages.front(), "r.urdf:1:1: error: the robot has more than 5000 links");
}

}  // namespace
}  // namespace pongsim::urdf::test
