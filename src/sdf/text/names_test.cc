#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Names, AreNeeded) {
  EXPECT_EQ(loadModel("<link/>\n<link name=''/>").messages,
            (Messages{"t.sdf:3:1: error: <link> in model 'm' has no name | write <link name=\"...\">",
                      "t.sdf:4:1: error: <link> in model 'm' has no name | write <link name=\"...\">"}));
}

TEST(Names, OfSiblingsDiffer) {
  EXPECT_EQ(
      loadModel("<link name='a'/>\n<link name='a'/>\n<frame name='a'/>").messages,
      (Messages{
          "t.sdf:4:1: error: link 'a' has the same name as another link of model 'm' | the first one is in line 3",
          "t.sdf:5:1: error: frame 'a' has the same name as a link of model 'm' | the first one is in line 3"}));
}

TEST(Names, OfTheFormatAreRefused) {
  const std::string hint = " | 'world' and names like __model__ are reserved";
  EXPECT_EQ(loadModel("<link name='world'/>\n<link name='__x__'/>").messages,
            (Messages{"t.sdf:3:7: error: link can't be named 'world' in model 'm'" + hint,
                      "t.sdf:4:7: error: link can't be named '__x__' in model 'm'" + hint}));
}

TEST(Names, HaveNoSeparator) {
  EXPECT_EQ(loadModel("<link name='a::b'/>").messages,
            Messages{"t.sdf:3:7: error: link can't be named 'a::b' in model 'm' | '::' separates the name of a model "
                     "from that of a part"});
  // names of a world's parts may have it: with a warning from SDF 1.8 on, without one in older files
  const std::string parts =
      "<model name='a::b'><link name='l'/></model><joint name='c::d' type='fixed'><parent>world</parent>"
      "<child>a::b::l</child></joint>";
  EXPECT_EQ(loadWorld(parts, "1.7").messages, Messages());
  const Loaded loaded = loadWorld(parts, "1.8");
  EXPECT_EQ(
      loaded.messages,
      (Messages{
          "t.sdf:2:8: warning: model is named 'a::b' in world 'w' | from SDF 1.8, Fortress refuses '::' in names",
          "t.sdf:2:51: warning: joint is named 'c::d' in world 'w' | from SDF 1.8, Fortress refuses '::' in names"}));
  EXPECT_EQ(loaded.world().joints.at(0).child, "a::b::l");
}

}  // namespace
}  // namespace pongsim::sdf::test
