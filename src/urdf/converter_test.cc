#include "urdf/converter.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

TEST(Converter, MakesAModelOfTheRobot) {
  const Converted converted = convert("<origin xyz='1 2 3'/>" + linkNamed("a"));
  EXPECT_EQ(converted.messages, Messages());
  EXPECT_EQ(converted.sdf->attributeOr("version", ""), "1.7");
  EXPECT_EQ(converted.model().attributeOr("name", ""), "r");
  EXPECT_EQ(textAt(converted.model(), "pose"), "1 2 3 0 0 0");
  EXPECT_TRUE(converted.has("link", "a"));
}

TEST(Converter, TellsAllMistakesInOneGo) {
  const Converted converted =
      convert("<link name='a'><inertial><mass value='x'/></inertial></link>\n" + jointNamed("j", "fixd", "a", "b"));
  EXPECT_FALSE(converted.sdf);
  EXPECT_EQ(converted.messages,
            (Messages{
                "r.urdf:2:16: error: the <inertial> of link 'a' has no <inertia>",
                "r.urdf:2:32: error: attribute 'value' of <mass> is 'x', which is not a finite number",
                "r.urdf:3:17: error: joint 'j' has the unknown type 'fixd' | did you mean 'fixed'?",
                "r.urdf:3:54: error: joint 'j' names child link 'b', which does not exist",
            }));
}

TEST(Converter, LeavesOutLinksWithoutMassAndWhatHangsOnThem) {
  const Converted converted =
      convert(linkNamed("a") + "<link name='b'/>\n" + linkNamed("c") +
              "<link name='z'><inertial><mass value='0'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>"
              "</inertial></link>\n" +
              jointNamed("j", "continuous", "a", "b") + jointNamed("k", "continuous", "b", "c") +
              jointNamed("l", "continuous", "a", "z"));
  EXPECT_EQ(converted.messages, (Messages{
                                    "r.urdf:3:1: warning: link 'b' has no mass: it is ignored, with its joint and all "
                                    "links below it | give it an <inertial> with a mass",
                                    "r.urdf:5:16: warning: link 'z' has a mass that is not above zero: it is ignored, "
                                    "with its joint and all links below it | give it an <inertial> with a mass",
                                }));
  EXPECT_TRUE(converted.has("link", "a"));
  EXPECT_FALSE(converted.has("link", "c"));
  EXPECT_FALSE(converted.has("joint", "k"));
}

// which libsdformat 12 does not keep
TEST(Converter, LeavesOutFramesOfLumpedLinksWhoseNamesTheRobotUses) {
  const Converted converted = convert(
      linkNamed("base") + "<link name='lamp_link'/>" +
      "<joint name='lamp' type='fixed'><parent link='base'/><child link='lamp_link'/><origin xyz='1 0 0'/></joint>"
      "<gazebo><model name='lamp'><link name='body'/></model></gazebo>");
  EXPECT_EQ(converted.messages, Messages());
  std::vector<const Element*> frames = converted.model().childrenNamed("frame");
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0]->attributeOr("name", ""), "lamp_link");
  EXPECT_EQ(frames[0]->attributeOr("attached_to", ""), "base");
  EXPECT_EQ(textAt(*frames[0], "pose"), "1 0 0 0 0 0");
}

TEST(Converter, BearsAChainOfAsManyLinksAsThereMayBe) {
  std::string chain = linkNamed("l0");
  for (int i = 1; i < 5000; ++i) {
    const std::string name = "l" + std::to_string(i);
    chain += linkNamed(name) + jointNamed("j" + name, "continuous", "l" + std::to_string(i - 1), name);
  }
  const Converted converted = convert(chain);
  EXPECT_EQ(converted.messages, Messages());
  EXPECT_TRUE(converted.has("link", "l4999"));
}

}  // namespace
}  // namespace pongsim::urdf::test
