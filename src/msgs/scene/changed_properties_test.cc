#include "msgs/scene/changed_properties.hh"

#include <gtest/gtest.h>

namespace pongsim::msgs {
namespace {

TEST(ChangedProperties, GiveVisualsTheirColors) {
  description::Visual visual;
  const VisualId id{3};
  EXPECT_FALSE(materialNow(visual, id, {}));
  const ChangedProperties red{{{id, {.diffuse = Vector3(1, 0, 0)}}}, {}};
  EXPECT_EQ(materialNow(visual, id, red)->diffuse.red, 1) << "also of one without a material";
  visual.material.emplace();
  visual.material->diffuse.alpha = 0.5F;
  visual.material->isLit = false;
  EXPECT_EQ(materialNow(visual, VisualId{4}, red), visual.material);
  const description::Material now = *materialNow(visual, id, red);
  EXPECT_EQ(now.diffuse.red, 1);
  EXPECT_EQ(now.diffuse.alpha, 0.5F);
  EXPECT_EQ(now.ambient.red, 1);
  EXPECT_FALSE(now.isLit);
  EXPECT_EQ(now.emissive.red, 0);
  const VisualColors rest{.ambient = Vector3(0, 1, 0), .specular = Vector3(0, 0, 1), .emissive = Vector3(1, 1, 0)};
  const description::Material others = *materialNow(visual, id, {{{id, rest}}, {}});
  EXPECT_EQ(others.diffuse, visual.material->diffuse);
  EXPECT_EQ(others.ambient.green, 1);
  EXPECT_EQ(others.specular.blue, 1);
  EXPECT_EQ(others.emissive.green, 1);
}

}  // namespace
}  // namespace pongsim::msgs
