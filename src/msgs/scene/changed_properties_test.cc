#include "msgs/scene/changed_properties.hh"

#include <gtest/gtest.h>

namespace pongsim::msgs {
namespace {

TEST(ChangedProperties, GiveVisualsTheirColors) {
  description::Visual visual;
  const VisualId id{3};
  EXPECT_FALSE(materialNow(visual, id, {}));
  const ChangedProperties red{{{id, {Vector3(1, 0, 0)}}}, {}};
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
  EXPECT_EQ(materialNow(visual, id, {{{id, {Vector3(1, 0, 0), true}}}, {}})->emissive.red, 1) << "where it glows";
}

}  // namespace
}  // namespace pongsim::msgs
