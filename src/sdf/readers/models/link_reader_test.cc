#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Link, ReadsItsFlagsAndDecay) {
  const Loaded loaded = loadLink(
      "<gravity>false</gravity><kinematic>1</kinematic><self_collide>true</self_collide>"
      "<velocity_decay><linear>0.1</linear><angular>0.2</angular></velocity_decay>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Link& link = loaded.model().links.at(0);
  EXPECT_FALSE(link.gravity);
  EXPECT_TRUE(link.kinematic);
  EXPECT_EQ(link.selfCollide, true);
  EXPECT_EQ(link.linearDamping, 0.1);
  EXPECT_EQ(link.angularDamping, 0.2);
  EXPECT_EQ(link.position.line, 3);
}

TEST(Link, HasTheDefaultsOfTheFormat) {
  const Loaded loaded = loadLink("");
  const description::Link& link = loaded.model().links.at(0);
  EXPECT_TRUE(link.gravity);
  EXPECT_FALSE(link.kinematic);
  EXPECT_EQ(link.selfCollide, std::nullopt);
  EXPECT_EQ(link.linearDamping, 0);
}

TEST(Link, ReadsSurfaces) {
  const Loaded loaded = loadLink(
      "<collision name='c'><geometry><box/></geometry><surface><friction><ode><mu>0.5</mu><mu2>0.25</mu2>"
      "<fdir1>1 0 0</fdir1><slip1>0.125</slip1><slip2>2</slip2></ode></friction><contact><collide_bitmask>0x1f"
      "</collide_bitmask></contact><bounce><restitution_coefficient>0.75</restitution_coefficient></bounce>"
      "</surface></collision>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Surface& surface = loaded.model().links.at(0).collisions.at(0).surface;
  EXPECT_EQ(surface.mu, 0.5);
  EXPECT_EQ(surface.mu2, 0.25);
  EXPECT_EQ(surface.fdir1, Vector3(1, 0, 0));
  EXPECT_EQ(surface.slip1, 0.125);
  EXPECT_EQ(surface.slip2, 2);
  EXPECT_EQ(surface.collideBitmask, 0x1f);
  EXPECT_EQ(surface.restitution, 0.75);
}

std::string wheelWithDirection(const std::string& attribute) {
  return "<collision name='c'><geometry><sphere/></geometry><surface><friction><ode><fdir1 " + attribute +
         ">1 1 0</fdir1></ode></friction></surface></collision>";
}

TEST(Link, ReadsTheLinkThatAFrictionDirectionIsFixedTo) {
  for (const char* attribute : {"ignition:expressed_in='l'", "gz:expressed_in='l'"}) {
    const Loaded loaded = loadLink(wheelWithDirection(attribute));
    EXPECT_EQ(loaded.messages, Messages());
    EXPECT_EQ(loaded.model().links.at(0).collisions.at(0).surface.fdir1Link, "l");
  }
}

TEST(Link, TakesAFrictionDirectionInTheCollisionWhereItsLinkIsNotThere) {
  const Loaded loaded = loadLink(wheelWithDirection("ignition:expressed_in='lin'"));
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_NE(loaded.messages[0].find("expressed in 'lin', which is not a link of model"), std::string::npos)
      << loaded.messages[0];
  EXPECT_EQ(loaded.model().links.at(0).collisions.at(0).surface.fdir1Link, "");
}

TEST(Link, ReadsWhatASurfaceDoesBesideRubbing) {
  const Loaded loaded = loadLink(
      "<collision name='c'><geometry><box/></geometry><max_contacts>3</max_contacts><surface><friction><torsional>"
      "<coefficient>0.5</coefficient><patch_radius>0.25</patch_radius><surface_radius>2</surface_radius>"
      "<use_patch_radius>false</use_patch_radius><ode><slip>0.125</slip></ode></torsional></"
      "friction><bounce><threshold>0.5</threshold></bounce></surface></collision>");
  EXPECT_EQ(loaded.messages, Messages());
  const std::vector<description::Collision>& collisions = loaded.model().links.at(0).collisions;
  const description::Surface& surface = collisions.at(0).surface;
  EXPECT_EQ(surface.torsion, (description::Torsion{0.5, 0.25, 2, false, 0.125}));
  EXPECT_EQ(surface.bounceThreshold, 0.5);
  EXPECT_EQ(surface.maxContacts, 3);
}

// as in Fortress, whose engine ignores the stiffness
TEST(Link, HasARigidSurfaceWhateverItsStiffness) {
  const Loaded loaded = loadLink(
      "<collision name='c'><geometry><box/></geometry><surface><contact><ode><kp>0</kp><kd>20</kd><max_vel>1</max_vel>"
      "<min_depth>0.001</min_depth></ode></contact></surface></collision>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().links.at(0).collisions.at(0).surface, description::Surface());
}

TEST(Link, MeasuresItsPartsInItselfOrInAnotherFrame) {
  const Loaded loaded = loadModel(
      "<frame name='f'><pose>10 0 0 0 0 0</pose></frame><link name='l'><pose>1 0 0 0 0 0</pose>"
      "<collision name='a'><pose>0 0 1 0 0 0</pose><geometry><box/></geometry></collision>"
      "<collision name='b'><pose relative_to='f'>0 0 1 0 0 0</pose><geometry><box/></geometry></collision>"
      "<visual name='v'><pose relative_to='__model__'>0 0 1 0 0 0</pose><geometry><box/></geometry></visual></link>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Link& link = loaded.model().links.at(0);
  expectPose(link.collisions.at(0).X_LinkCollision, {0, 0, 1});
  expectPose(link.collisions.at(1).X_LinkCollision, {9, 0, 1});
  expectPose(link.visuals.at(0).X_LinkVisual, {-1, 0, 1});
}

TEST(Link, NamesTheFrameThatAPartLacks) {
  EXPECT_EQ(loadLink("<visual name='v'><pose relative_to='nosuch'/><geometry><box/></geometry></visual>").messages,
            Messages{"t.sdf:4:24: error: the pose of visual 'v' is relative to 'nosuch', which is not in model 'm'"});
}

TEST(Link, HasPartsOfDifferentNames) {
  const std::string box = "<geometry><box/></geometry>";
  EXPECT_EQ(
      loadLink("<visual name='a'>" + box + "</visual><collision name='a'>" + box + "</collision>\n" +
               "<collision name='a'>" + box + "</collision>")
          .messages,
      Messages{"t.sdf:5:1: error: collision 'a' has the same name as another collision of link 'l' of model 'm' | "
               "the first one is in line 4"});
}

TEST(Link, HasLights) {
  const Loaded loaded = loadModel(
      "<frame name='f'><pose>5 0 0 0 0 0</pose></frame><link name='l'><pose>1 0 0 0 0 0</pose>"
      "<light name='a' type='spot'><pose>0 0 1 0 0 0</pose></light>"
      "<light name='b' type='point'><pose relative_to='f'>0 2 0 0 0 0</pose></light>\n"
      "<light name='a' type='point'/></link>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:4:1: error: light 'a' has the same name as another light of link 'l' of "
                                      "model 'm' | the first one is in line 3"});
  const auto& lights = loaded.model().links.at(0).lights;
  expectPose(lights.at(0).X_ParentLight, {0, 0, 1});
  expectPose(lights.at(1).X_ParentLight, {4, 2, 0});
}

TEST(Link, IsInTheWindWhereItSaysSo) {
  const Loaded loaded = loadModel(
      "<enable_wind>true</enable_wind><link name='a'/><link name='b'><enable_wind>false</enable_wind></link>");
  EXPECT_TRUE(loaded.model().isInWind);
  EXPECT_EQ(loaded.model().links.at(0).isInWind, std::nullopt);
  EXPECT_EQ(loaded.model().links.at(1).isInWind, false);
}

}  // namespace
}  // namespace pongsim::sdf::test
