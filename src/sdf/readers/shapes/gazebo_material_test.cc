#include "sdf/readers/shapes/gazebo_material.hh"

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

using description::Color;

description::Material loadNamed(const std::string& content) {
  const Loaded loaded =
      loadLink("<visual name='v'><geometry><box/></geometry><material>\n" + content + "</material></visual>");
  EXPECT_EQ(loaded.messages, Messages());
  return *loaded.model().links.at(0).visuals.at(0).material;
}

TEST(GazeboMaterial, HasTheColoursOfItsName) {
  ASSERT_NE(gazeboMaterial("Gazebo/Orange"), nullptr);
  EXPECT_EQ(gazeboMaterial("Gazebo/Orange")->diffuse, (Color{1, 0.5088F, 0.0468F, 1}));
  EXPECT_EQ(gazeboMaterial("Gazebo/Orange")->specular, (Color{0.5F, 0.5F, 0.5F, 1}));
  EXPECT_EQ(gazeboMaterial("Gazebo/Grey")->ambient, (Color{0.3F, 0.3F, 0.3F, 1}));
  EXPECT_EQ(gazeboMaterial("Gazebo/GreenTransparent")->diffuse.alpha, 0.5F);
  EXPECT_EQ(gazeboMaterial("Gazebo/BlueGlow")->emissive, (Color{0, 0, 1, 1}));
  EXPECT_FALSE(gazeboMaterial("Gazebo/RedTransparent")->isLit);
  // the first and the last, and beyond them
  EXPECT_NE(gazeboMaterial("Gazebo/Black"), nullptr);
  EXPECT_NE(gazeboMaterial("Gazebo/ZincYellow"), nullptr);
  for (const char* name : {"", "Gazebo", "Gazebo/", "Gazebo/A", "Gazebo/Zz", "Gazebo/blue", "Blue", "gazebo/Blue"}) {
    EXPECT_EQ(gazeboMaterial(name), nullptr) << name;
  }
}

TEST(GazeboMaterial, ColoursAVisualThatNamesIt) {
  const description::Material material =
      loadNamed("<script><uri>file://media/materials/scripts/gazebo.material</uri><name>Gazebo/Red</name></script>");
  EXPECT_EQ(material.diffuse, (Color{1, 0, 0, 1}));
  EXPECT_EQ(material.ambient, (Color{1, 0, 0, 1}));
  EXPECT_EQ(material.specular, (Color{0.1F, 0.1F, 0.1F, 1}));
  EXPECT_EQ(material.scriptName, "Gazebo/Red");
}

TEST(GazeboMaterial, LeavesColoursThatAreGiven) {
  const description::Material material =
      loadNamed("<diffuse>0 1 0 1</diffuse><script><name>Gazebo/Red</name></script>");
  EXPECT_EQ(material.diffuse, (Color{0, 1, 0, 1}));
  EXPECT_EQ(material.ambient, (Color{1, 0, 0, 1}));
  EXPECT_EQ(loadNamed("<script><name>mine</name></script>").diffuse, (Color{0, 0, 0, 1}));
}

}  // namespace
}  // namespace pongsim::sdf::test
