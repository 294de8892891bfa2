#include "pongsim/appearance.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim {
namespace {

using test::RunningWorld;

TEST(Appearance, HasEachVisualInItsPlace) {
  RunningWorld world(std::string(R"(<model name='outer'><static>true</static><pose>1 0 0 0 0 1.5707963267948966</pose>
    <model name='inner'><link name='l'><pose>2 0 0 0 0 0</pose>
      <visual name='v'><pose>0 0 3 0 0 0</pose><transparency>0.5</transparency>
        <geometry><box><size>1 2 4</size></box></geometry>
        <material><diffuse>1 0.5 0.25 0.5</diffuse><specular>0 0 1 1</specular></material></visual>
      <visual name='unseen'><transparency>1</transparency><geometry><sphere><radius>1</radius></sphere></geometry>
        </visual></link></model></model>)"));
  Diagnostics diagnostics;
  const Appearance appearance(world.simulation().world(), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  ASSERT_EQ(appearance.partCount(), 1U);
  const VisiblePart part = appearance.part(0);
  EXPECT_EQ(part.name, "outer::inner::l::v");
  EXPECT_LT((part.X_WorldPart.position - Vector3(1, 2, 3)).norm(), 1e-12);
  EXPECT_NEAR(yawOf(part.X_WorldPart.rotation), std::acos(0.0), 1e-12);
  EXPECT_EQ(part.scale, Vector3(1, 2, 4));
  EXPECT_EQ(part.corners.size(), 24U);
  EXPECT_EQ(part.triangles.size(), 36U);
  EXPECT_EQ(part.diffuse, Eigen::Vector3f(1, 0.5F, 0.25F));
  EXPECT_EQ(part.specular, Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(part.opacity, 0.25);
  EXPECT_TRUE(part.texture.empty());
  EXPECT_THROW(appearance.part(1), std::out_of_range);
}

TEST(Appearance, HasTheLightsThatAreOn) {
  RunningWorld world(std::string(R"(<light name='sun' type='directional'><direction>1 0 -1</direction></light>
    <light name='off' type='point'><light_on>false</light_on></light>
    <model name='m'><static>true</static><pose>0 0 5 0 0 0</pose><link name='l'>
      <light name='lamp' type='spot'><pose>1 0 0 0 0 0</pose><diffuse>1 0.5 0 1</diffuse>
        <attenuation><range>9</range><constant>0.5</constant><linear>0.25</linear><quadratic>0.125</quadratic>
        </attenuation><spot><inner_angle>0.5</inner_angle><outer_angle>1</outer_angle><falloff>2</falloff></spot>
      </light></link></model>)"));
  Diagnostics diagnostics;
  const std::vector<VisibleLight> lights = Appearance(world.simulation().world(), diagnostics).lights();
  ASSERT_EQ(lights.size(), 2U);
  for (const VisibleLight& light : lights) {
    if (light.name == "sun") {
      EXPECT_EQ(light.type, VisibleLight::Type::kDirectional);
      EXPECT_LT((light.direction - Vector3(1, 0, -1).normalized()).norm(), 1e-12);
      continue;
    }
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.type, VisibleLight::Type::kSpot);
    EXPECT_LT((light.X_WorldLight.position - Vector3(1, 0, 5)).norm(), 1e-12);
    EXPECT_EQ(light.diffuse, Vector3(1, 0.5, 0));
    EXPECT_EQ(light.constantAttenuation, 0.5);
    EXPECT_EQ(light.linearAttenuation, 0.25);
    EXPECT_EQ(light.quadraticAttenuation, 0.125);
    EXPECT_EQ(light.outerAngle, 1);
    EXPECT_EQ(light.falloff, 2);
  }
}

TEST(Appearance, SaysWhichMeshCantBeRead) {
  const test::TempFolder folder;
  const std::string file = folder.write("broken.dae", "no mesh").string();
  RunningWorld world("<model name='m'><static>true</static><link name='l'><visual name='v'><geometry><mesh><uri>" +
                     file + "</uri></mesh></geometry></visual></link></model>");
  Diagnostics diagnostics;
  const Appearance appearance(world.simulation().world(), diagnostics);
  EXPECT_EQ(appearance.partCount(), 0U);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_NE(diagnostics.all()[0].message.find("mesh '" + file + "'"), std::string::npos);
}

}  // namespace
}  // namespace pongsim
