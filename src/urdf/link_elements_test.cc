#include "urdf/link_elements.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

const std::string kBall = "<geometry><sphere radius='0.5'/></geometry>";

TEST(LinkElements, HaveShapesAndInertiaOfTheLink) {
  const Converted converted =
      convert(linkNamed("a",
                        "<collision><origin xyz='1 2 3'/><geometry><box size='1 2 3'/></geometry></collision>"
                        "<collision name='mine'><geometry><cylinder radius='1' length='2'/></geometry></collision>"
                        "<visual><geometry><mesh filename='package://p/m.stl' scale='1 1 -2'/></geometry></visual>"));
  EXPECT_EQ(converted.messages, Messages());
  const Element& link = converted.part("link", "a");
  EXPECT_EQ(textAt(link, "inertial/mass"), "1");
  EXPECT_EQ(textAt(link, "inertial/inertia/iyy"), "0.1");
  const auto collisions = link.childrenNamed("collision");
  ASSERT_EQ(collisions.size(), 2U);
  EXPECT_EQ(collisions[0]->attributeOr("name", ""), "a_collision");
  EXPECT_EQ(textAt(*collisions[0], "pose"), "1 2 3 0 0 0");
  EXPECT_EQ(textAt(*collisions[0], "geometry/box/size"), "1 2 3");
  EXPECT_EQ(collisions[1]->attributeOr("name", ""), "a_fixed_joint_lump__mine_collision_1");
  EXPECT_EQ(textAt(*collisions[1], "geometry/cylinder/length"), "2");
  EXPECT_EQ(textAt(link, "visual/geometry/mesh/uri"), "model://p/m.stl");
  EXPECT_EQ(textAt(link, "visual/geometry/mesh/scale"), "1 1 -2");
}

TEST(LinkElements, NameWhatWasLumpedAsFortressDoes) {
  const Converted converted =
      convert("<link name='foot'/>" + linkNamed("base", "<collision>" + kBall + "</collision>") +
              linkNamed("lidar", "<collision>" + kBall + "</collision><visual>" + kBall + "</visual>") +
              jointNamed("j", "fixed", "foot", "base", "<origin xyz='0 0 1'/>") +
              jointNamed("k", "fixed", "base", "lidar", "<origin xyz='1 0 0'/>"));
  EXPECT_EQ(converted.messages, Messages());
  const Element& link = converted.part("link", "foot");
  const auto collisions = link.childrenNamed("collision");
  ASSERT_EQ(collisions.size(), 2U);
  EXPECT_EQ(collisions[0]->attributeOr("name", ""), "foot_fixed_joint_lump__base_collision");
  EXPECT_EQ(collisions[1]->attributeOr("name", ""), "foot_fixed_joint_lump__lidar_collision_1");
  EXPECT_EQ(textAt(*collisions[1], "pose"), "1 0 1 0 0 0");
  EXPECT_EQ(link.child("visual")->attributeOr("name", ""), "foot_fixed_joint_lump__lidar_visual");
  EXPECT_FALSE(converted.has("link", "lidar"));
}

TEST(LinkElements, KeepTheFramesOfLumpedLinksAndJoints) {
  const Converted converted = convert(linkNamed("base") + linkNamed("lidar") +
                                      jointNamed("k", "fixed", "base", "lidar", "<origin xyz='1 0 0'/>"));
  const Element& joint = converted.part("frame", "k");
  EXPECT_EQ(joint.attributeOr("attached_to", ""), "base");
  EXPECT_EQ(textAt(joint, "pose"), "1 0 0 0 0 0");
  EXPECT_EQ(converted.part("frame", "lidar").attributeOr("attached_to", ""), "k");
}

TEST(LinkElements, AreAsBrightAsFortressMakesThem) {
  const Converted converted = convert("<material name='m'><color rgba='0.4 1 0 0.5'/></material>" +
                                      linkNamed("a", "<visual>" + kBall + "<material name='m'/></visual>"));
  EXPECT_EQ(textAt(converted.part("link", "a"), "visual/material/diffuse"), "0.5 1 0 0.5");
  EXPECT_EQ(textAt(converted.part("link", "a"), "visual/material/ambient"), "0.5 1 0 0.5");
}

TEST(LinkElements, HaveThePositionsOfTheirUrdf) {
  const Converted converted = convert(linkNamed("a", "\n<collision>\n<origin/>\n" + kBall + "</collision>"));
  const Element& collision = *converted.part("link", "a").child("collision");
  EXPECT_EQ(collision.position.line, 3);
  EXPECT_EQ(collision.child("pose")->position.line, 4);
  EXPECT_EQ(collision.child("geometry")->child("sphere")->child("radius")->position.line, 5);
}

}  // namespace
}  // namespace pongsim::urdf::test
