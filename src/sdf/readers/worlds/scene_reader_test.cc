#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Scene, HasTheDefaultsOfTheFormat) {
  EXPECT_EQ(loadWorld("").world().scene, description::Scene());
  EXPECT_EQ(loadWorld("<scene/>").world().scene, description::Scene());
  EXPECT_FALSE(description::Scene().sky);
}

TEST(Scene, ReadsAll) {
  const Loaded loaded = loadWorld(
      "<scene><ambient>1 0 0</ambient><background>0 1 0</background><shadows>false</shadows><grid>false</grid>"
      "<origin_visual>false</origin_visual><sky><time>1</time><sunrise>2</sunrise><sunset>3</sunset><clouds>"
      "<speed>4</speed><direction>5</direction><humidity>6</humidity><mean_size>7</mean_size><ambient>0 0 1</ambient>"
      "</clouds></sky><fog><type>linear</type><color>1 1 0</color><start>8</start><end>9</end><density>0.5</density>"
      "</fog></scene>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Scene& scene = loaded.world().scene;
  EXPECT_EQ(scene.ambient, (description::Color{1, 0, 0, 1}));
  EXPECT_EQ(scene.background, (description::Color{0, 1, 0, 1}));
  EXPECT_FALSE(scene.hasShadows || scene.hasGrid || scene.showsOrigin);
  EXPECT_EQ(scene.sky, (description::Sky{1, 2, 3, 4, 5, 6, 7, {0, 0, 1, 1}}));
  EXPECT_EQ(scene.fog, (description::Fog{description::Fog::Type::kLinear, {1, 1, 0, 1}, 8, 9, 0.5}));
}

TEST(Scene, SaysWhatIsWrong) {
  EXPECT_EQ(loadWorld("<scene><fog><type>thick</type></fog></scene>").messages,
            Messages{"t.sdf:2:13: error: <type> has the unknown value 'thick' | it can be none, constant, linear, "
                     "quadratic"});
}

}  // namespace
}  // namespace pongsim::sdf::test
