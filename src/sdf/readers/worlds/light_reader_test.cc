#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

description::Light lightOf(const std::string& content, const std::string& type = "point") {
  const Loaded loaded = loadWorld("<light name='l' type='" + type + "'>" + content + "</light>");
  EXPECT_EQ(loaded.messages, Messages());
  return loaded.world().lights.at(0);
}

TEST(Light, HasTheDefaultsOfTheFormat) {
  description::Light light = lightOf("");
  EXPECT_EQ(light.name, "l");
  EXPECT_EQ(light.type, description::LightType::kPoint);
  EXPECT_TRUE(light.isOn);
  EXPECT_FALSE(light.castsShadows);
  EXPECT_EQ(light.intensity, 1);
  EXPECT_EQ(light.diffuse, (description::Color{1, 1, 1, 1}));
  EXPECT_EQ(light.specular, (description::Color{0.1F, 0.1F, 0.1F, 1}));
  EXPECT_EQ(light.direction, Vector3(0, 0, -1));
  EXPECT_EQ(light.range, 10);
}

TEST(Light, ReadsAll) {
  const description::Light light = lightOf(
      "<pose>1 2 3 0 0 0</pose><cast_shadows>true</cast_shadows><light_on>false</light_on><visualize>false</visualize>"
      "<intensity>2</intensity><diffuse>0.5 0.25 1</diffuse><specular>1 1 1 0.5</specular>"
      "<direction>0 3 -4</direction><attenuation><range>20</range><constant>0.9</constant><linear>0.01</linear>"
      "<quadratic>0.001</quadratic></attenuation><spot><inner_angle>0.1</inner_angle><outer_angle>0.5</outer_angle>"
      "<falloff>0.8</falloff></spot>",
      "spot");
  EXPECT_EQ(light.type, description::LightType::kSpot);
  expectPose(light.X_ParentLight, {1, 2, 3});
  EXPECT_TRUE(light.castsShadows);
  EXPECT_FALSE(light.isOn);
  EXPECT_FALSE(light.isVisualized);
  EXPECT_EQ(light.intensity, 2);
  EXPECT_EQ(light.diffuse, (description::Color{0.5F, 0.25F, 1, 1}));
  EXPECT_EQ(light.specular.alpha, 0.5F);
  EXPECT_LT((light.direction - Vector3(0, 0.6, -0.8)).norm(), 1e-15);
  EXPECT_EQ(light.range, 20);
  EXPECT_EQ(light.constantAttenuation, 0.9);
  EXPECT_EQ(light.linearAttenuation, 0.01);
  EXPECT_EQ(light.quadraticAttenuation, 0.001);
  EXPECT_EQ(light.innerAngle, 0.1);
  EXPECT_EQ(light.outerAngle, 0.5);
  EXPECT_EQ(light.falloff, 0.8);
}

TEST(Light, SaysWhatIsWrong) {
  EXPECT_EQ(loadWorld("<light name='l' type='spt'/>").messages,
            Messages{"t.sdf:2:17: error: attribute 'type' has the unknown value 'spt' | did you mean 'spot'?"});
  EXPECT_EQ(loadWorld("<light name='l' type='spot'>\n<direction>0 0 0</direction></light>").messages,
            Messages{"t.sdf:3:1: warning: <direction> of light 'l' has length zero: 0 0 -1 is used"});
  EXPECT_EQ(
      loadWorld("<light name='l' type='spot'>\n<diffuse>1 -1 0</diffuse></light>").messages,
      Messages{"t.sdf:3:1: error: <diffuse> is '1 -1 0', which is not three or four finite, non-negative numbers, "
               "red green blue alpha"});
  EXPECT_EQ(loadWorld("<light name='l' type='spot'>\n<attenuation><range>far</range></attenuation></light>").messages,
            Messages{"t.sdf:3:14: error: <range> is 'far', which is not a number"});
}

}  // namespace
}  // namespace pongsim::sdf::test
