#include "urdf/xml_text.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

TEST(XmlText, HoldsWhatIsUrdfAndNothingElse) {
  const Element robot = robotWith(
      "<!-- a -- b --><link name='a&amp;&lt;&quot;'> text <x y='1'/></link><gazebo><link name='no'/></gazebo>"
      "<material name='m'/><transmission/>");
  EXPECT_EQ(xmlOf(robot),
            "<robot name=\"r\"><link name=\"a&amp;&lt;&quot;\"><x y=\"1\"></x>text</link>"
            "<material name=\"m\"></material></robot>");
}

}  // namespace
}  // namespace pongsim::urdf::test
