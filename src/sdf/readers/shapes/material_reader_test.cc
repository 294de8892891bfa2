#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

Loaded loadMaterial(const std::string& content) {
  return loadLink("<visual name='v'><geometry><box/></geometry><material>\n" + content + "</material></visual>");
}

const description::Material& materialOf(const Loaded& loaded) {
  return *loaded.model().links.at(0).visuals.at(0).material;
}

TEST(Material, IsBlackAndLitByDefault) {
  const Loaded loaded = loadMaterial("");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(materialOf(loaded), description::Material());
  EXPECT_EQ(materialOf(loaded).diffuse, (description::Color{0, 0, 0, 1}));
  EXPECT_TRUE(materialOf(loaded).isLit);
}

TEST(Material, ReadsColoursAndScripts) {
  const Loaded loaded = loadMaterial(
      "<ambient>0.1 0.2 0.3 0.4</ambient><diffuse>1 0 0</diffuse><specular>0 1 0 1</specular>"
      "<emissive>0 0 1 1</emissive><lighting>false</lighting><double_sided>true</double_sided>"
      "<render_order>2</render_order><script><uri>a</uri><uri>b</uri><name>n</name></script>"
      "<shader type='vertex'/>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Material& material = materialOf(loaded);
  EXPECT_EQ(material.ambient, (description::Color{0.1F, 0.2F, 0.3F, 0.4F}));
  EXPECT_EQ(material.diffuse, (description::Color{1, 0, 0, 1}));
  EXPECT_EQ(material.specular, (description::Color{0, 1, 0, 1}));
  EXPECT_EQ(material.emissive, (description::Color{0, 0, 1, 1}));
  EXPECT_FALSE(material.isLit);
  EXPECT_TRUE(material.isDoubleSided);
  EXPECT_EQ(material.renderOrder, 2);
  EXPECT_EQ(material.scriptUris, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(material.scriptName, "n");
  EXPECT_EQ(material.shader, "vertex");
  EXPECT_FALSE(material.metal || material.gloss);
}

TEST(Material, ReadsBothWaysOfPbr) {
  const pongsim::test::TempFolder folder;
  const std::string file = folder.write("a.png", "x").string();
  const Loaded loaded = loadMaterial("<pbr><metal><albedo_map>" + file + "</albedo_map><normal_map type='object'>" +
                                     file + "</normal_map><roughness>0.1</roughness><metalness>0.2</metalness>" +
                                     "<roughness_map>" + file + "</roughness_map><light_map uv_set='3'>" + file +
                                     "</light_map></metal><specular><glossiness>0.3</glossiness><specular_map>" + file +
                                     "</specular_map><emissive_map>" + file + "</emissive_map></specular></pbr>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Texture texture{file, file};
  const description::PbrMetal& metal = *materialOf(loaded).metal;
  EXPECT_EQ(metal.maps.albedo, texture);
  EXPECT_EQ(metal.maps.normal, texture);
  EXPECT_TRUE(metal.maps.areNormalsOfObject);
  EXPECT_EQ(metal.maps.lightCoordinates, 3U);
  EXPECT_EQ(metal.roughness, 0.1);
  EXPECT_EQ(metal.roughnessMap, texture);
  EXPECT_EQ(metal.metalness, 0.2);
  EXPECT_EQ(metal.metalnessMap, description::Texture());
  const description::PbrSpecular& gloss = *materialOf(loaded).gloss;
  EXPECT_EQ(gloss.glossiness, 0.3);
  EXPECT_EQ(gloss.specularMap, texture);
  EXPECT_EQ(gloss.maps.emissive, texture);
}

TEST(Material, WarnsOnceOfATextureThatIsMissing) {
  const Loaded loaded =
      loadMaterial("<pbr><metal><albedo_map>/no/a.png</albedo_map>\n<normal_map>/no/a.png</normal_map></metal></pbr>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:5:13: warning: <albedo_map> '/no/a.png' is not found | looked for it at "
                                      "/no/a.png; set PONGSIM_RESOURCE_PATH to search more folders"});
  EXPECT_EQ(materialOf(loaded).metal->maps.normal, (description::Texture{"/no/a.png", {}}));
}

TEST(Material, SaysWhatIsWrong) {
  EXPECT_EQ(loadMaterial("<pbr><metal><roughness>rough</roughness></metal></pbr>").messages,
            Messages{"t.sdf:5:13: error: <roughness> is 'rough', which is not a number"});
  EXPECT_EQ(loadMaterial("<pbr><metal><light_map uv_set='-1'/></metal></pbr>").messages,
            Messages{"t.sdf:5:24: error: attribute 'uv_set' is '-1', which is not an integer from 0 to 4294967295"});
  EXPECT_EQ(loadMaterial("<diffuse>1 1 1 1 1</diffuse>").messages,
            Messages{"t.sdf:5:1: warning: <diffuse> is '1 1 1 1 1', which is not three or four numbers, red green blue "
                     "alpha | Fortress reads as much of it as it can"});
}

}  // namespace
}  // namespace pongsim::sdf::test
