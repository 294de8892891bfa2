#include "load_support.hh"

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

TEST(Names, WereSharedByLinksAndJointsInOldFiles) {
  const Loaded loaded = loadModel(
      "<link name='a'/><joint name='b' type='fixed'><parent>a</parent><child>b</child></joint>\n<link name='b'/>",
      "1.6");
  EXPECT_EQ(
      loaded.messages,
      Messages{"t.sdf:4:1: warning: link 'b' has the same name as a joint of model 'm' | the first one is in line 3"});
  EXPECT_EQ(loaded.model().joints.at(0).child, "b");
}

TEST(Names, OfTheFormatAreRefused) {
  const std::string hint = " | 'world' and names like __model__ have a meaning of their own";
  EXPECT_EQ(loadModel("<link name='world'/>\n<link name='__x__'/>").messages,
            (Messages{"t.sdf:3:7: error: link can't be named 'world' in model 'm'" + hint,
                      "t.sdf:4:7: error: link can't be named '__x__' in model 'm'" + hint}));
}

TEST(Names, HaveNoSeparatorInNewFiles) {
  EXPECT_EQ(
      loadModel("<link name='a::b'/>").messages,
      Messages{
          "t.sdf:3:7: error: link can't be named 'a::b' in model 'm' | '::' stands between the name of a model and "
          "that of its part"});
  const Loaded old = loadModel(
      "<link name='a::b'/><link name='c'/><joint name='j' type='fixed'><parent>c</parent><child>a::b</child></joint>",
      "1.7");
  EXPECT_EQ(old.messages, Messages());
  EXPECT_EQ(old.model().joints.at(0).child, "a::b");
}

}  // namespace
}  // namespace pongsim::sdf::test
