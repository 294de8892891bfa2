#include "msgs/scene/material_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/material.pb.h>

namespace pongsim::msgs {
namespace {

namespace im = ignition::msgs;

TEST(MaterialMessage, TellsColoursAndLight) {
  description::Material material;
  material.diffuse = {0.25F, 0, 0.5F, 1};
  material.isLit = false;
  material.isDoubleSided = true;
  im::Material message;
  setMaterial(material, message);
  EXPECT_EQ(message.diffuse().r(), 0.25F);
  EXPECT_EQ(message.diffuse().b(), 0.5F);
  EXPECT_EQ(message.emissive().a(), 1);
  EXPECT_FALSE(message.lighting());
  EXPECT_TRUE(message.double_sided());
  EXPECT_FALSE(message.has_pbr());
}

TEST(MaterialMessage, TellsHowASurfaceReflects) {
  description::Material material;
  material.metal.emplace().metalness = 0.75;
  material.metal->maps.albedo = {"wood.png", "/pictures/wood.png"};
  material.metal->roughnessMap.uri = "rough.png";
  im::Material message;
  setMaterial(material, message);
  EXPECT_EQ(message.pbr().type(), im::Material::PBR::METAL);
  EXPECT_EQ(message.pbr().metalness(), 0.75);
  EXPECT_EQ(message.pbr().albedo_map(), "/pictures/wood.png");
  EXPECT_EQ(message.pbr().roughness_map(), "rough.png");

  material.metal.reset();
  material.gloss.emplace().glossiness = 0.5;
  setMaterial(material, message);
  EXPECT_EQ(message.pbr().type(), im::Material::PBR::SPECULAR);
  EXPECT_EQ(message.pbr().glossiness(), 0.5);
  EXPECT_EQ(message.pbr().albedo_map(), "");
}

TEST(MaterialMessage, MakesTheSameMaterialAgain) {
  description::Material material;
  material.diffuse = {0.25F, 0, 0.5F, 1};
  material.isLit = false;
  material.isDoubleSided = true;
  material.renderOrder = 2;
  im::Material message;
  setMaterial(material, message);
  EXPECT_EQ(materialFrom(message), material);
  material.metal.emplace().metalness = 0.75;
  material.metal->maps.albedo.uri = "wood.png";
  setMaterial(material, message);
  EXPECT_EQ(materialFrom(message), material);
  material.metal.reset();
  material.gloss.emplace().glossiness = 0.5;
  material.gloss->specularMap.uri = "shine.png";
  setMaterial(material, message);
  EXPECT_EQ(materialFrom(message), material);
}

}  // namespace
}  // namespace pongsim::msgs
