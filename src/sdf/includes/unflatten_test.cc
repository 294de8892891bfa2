#include "sdf/includes/unflatten.hh"

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Unflatten, MakesModelsOfTheirFlattenedParts) {
  const Loaded loaded = loadModel(
      "<link name='l'/>"
      "<frame name='in::__model__' attached_to='in::b'><pose relative_to='__model__'>0 0 1 0 0 0</pose></frame>"
      "<link name='in::a'><pose relative_to='in::__model__'>1 0 0 0 0 0</pose></link>"
      "<link name='in::b'><pose relative_to='in::a'>1 0 0 0 0 0</pose></link>"
      "<joint name='in::j' type='revolute'><parent>in::a</parent><child>in::b</child>"
      "<axis><xyz expressed_in='in::a'>0 1 0</xyz></axis></joint>"
      "<joint name='j' type='fixed'><parent>l</parent><child>in::a</child></joint>",
      "1.7");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Model& outer = loaded.model();
  ASSERT_EQ(outer.links.size(), 1U);
  ASSERT_EQ(outer.models.size(), 1U);
  EXPECT_EQ(outer.joints.at(0).child, "in::a");
  const description::Model& inner = outer.models[0];
  EXPECT_EQ(inner.name, "in");
  EXPECT_EQ(inner.canonicalLink, "b");
  expectPose(inner.X_ParentModel, {0, 0, 1});
  ASSERT_EQ(inner.links.size(), 2U);
  expectPose(inner.links[1].X_ModelLink, {2, 0, 0});
  EXPECT_EQ(inner.joints.at(0).name, "j");
  EXPECT_EQ(inner.joints[0].axes.at(0).xyz, Vector3(0, 1, 0));
}

TEST(Unflatten, GoesAsDeepAsTheNames) {
  const Loaded loaded = loadModel("<link name='a::b::l'/><link name='a::m'/><link name='ab::l'/>", "1.6");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Model& a = loaded.model().models.at(0);
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.links.at(0).name, "m");
  EXPECT_EQ(a.models.at(0).name, "b");
  EXPECT_EQ(a.models[0].links.at(0).name, "l");
  EXPECT_EQ(loaded.model().models.at(1).name, "ab");
}

TEST(Unflatten, RefusesToGoTooDeep) {
  std::string name;
  for (int i = 0; i < 101; ++i) name += "a::";
  const Loaded loaded = loadModel("<link name='" + name + "l'/>", "1.7");
  EXPECT_EQ(loaded.messages.at(0), "t.sdf:3:1: error: models nest more than 100 deep in the name of a link");
}

TEST(Unflatten, LeavesNewFilesAlone) {
  EXPECT_NE(loadModel("<link name='a::b'/>", "1.8").messages.at(0).find("error"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::sdf::test
