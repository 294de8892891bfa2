#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Model, ReadsItsFlags) {
  const Loaded loaded = loadModel("<static>true</static><self_collide>1</self_collide><link name='l'/>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_TRUE(loaded.model().isStatic);
  EXPECT_TRUE(loaded.model().selfCollide);
  EXPECT_EQ(loaded.model().position.line, 2);
  EXPECT_EQ(loaded.model().position.column, 1);
}

TEST(Model, HasItsFirstLinkAsCanonicalLink) {
  EXPECT_EQ(loadModel("<link name='a'/><link name='b'/>").model().canonicalLink, "a");
  EXPECT_EQ(loadModel("<model name='i'><link name='x'/></model><link name='a'/>").model().canonicalLink, "a");
  EXPECT_EQ(loadModel("<model name='i'><model name='k'><link name='x'/></model></model>").model().canonicalLink,
            "i::k::x");
}

TEST(Model, NamesItsCanonicalLink) {
  const auto canonical = [](const std::string& link) {
    return loadWorld(
        "<model name='m' canonical_link='" + link +
        "'><link name='a'/><link name='b'/><frame name='f'/><model name='i'><link name='x'/></model></model>");
  };
  EXPECT_EQ(canonical("b").model().canonicalLink, "b");
  EXPECT_EQ(canonical("i::x").model().canonicalLink, "i::x");
  EXPECT_EQ(canonical("nosuch").messages,
            Messages{"t.sdf:2:17: error: model 'm' has the canonical link 'nosuch', which is not in model 'm'"});
  EXPECT_EQ(canonical("f").messages,
            Messages{"t.sdf:2:17: error: the canonical link of model 'm', 'f', is not a link"});
}

TEST(Model, NeedsALinkUnlessItIsStatic) {
  EXPECT_EQ(loadModel("").messages,
            Messages{"t.sdf:2:1: error: model 'm' has no link | a model that is not static needs a <link>"});
  EXPECT_EQ(loadModel("<static>1</static>").messages, Messages());
  EXPECT_EQ(loadModel("<model name='i'><link name='l'/></model>").messages, Messages());
}

TEST(Model, IsPlacedByItsPlacementFrame) {
  const Loaded loaded = loadWorld(
      "<model name='m' placement_frame='f'><pose>5 0 0 0 0 0</pose><link name='l'/>"
      "<frame name='f'><pose>1 2 0 0 0 0</pose></frame></model>");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(loaded.model().X_ParentModel, {4, -2, 0});
  EXPECT_EQ(loadWorld("<model name='m' placement_frame='nosuch'><link name='l'/></model>").messages,
            Messages{"t.sdf:2:1: error: model 'm' is placed by its frame 'nosuch', which is not in model 'm'"});
}

TEST(Model, KeepsNestedModelsAndPlugins) {
  const Loaded loaded = loadModel(
      "<link name='a'/><model name='i'><pose>1 0 0 0 0 0</pose><link name='x'/>"
      "<plugin filename='p' name='q'><a b='c'>d</a></plugin></model>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Model& inner = loaded.model().models.at(0);
  expectPose(inner.X_ParentModel, {1, 0, 0});
  EXPECT_EQ(inner.links.at(0).name, "x");
  EXPECT_EQ(inner.plugins.at(0).sdf.child("a")->text, "d");
}

}  // namespace
}  // namespace pongsim::sdf::test
