#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Visual, HasTheDefaultsOfTheFormat) {
  const Loaded loaded = loadLink("<visual name='v'><geometry><box/></geometry></visual>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Visual& visual = loaded.model().links.at(0).visuals.at(0);
  EXPECT_FALSE(visual.material);
  EXPECT_EQ(visual.transparency, 0);
  EXPECT_TRUE(visual.castsShadows);
  EXPECT_EQ(visual.visibilityFlags, 0xFFFFFFFF);
  EXPECT_EQ(visual.laserRetro, 0);
}

TEST(Visual, ReadsAll) {
  const Loaded loaded = loadLink(
      "<visual name='v'><geometry><sphere/></geometry><material/><transparency>0.5</transparency>"
      "<cast_shadows>false</cast_shadows><visibility_flags>0x10</visibility_flags><laser_retro>50</laser_retro>"
      "<meta><layer>-2</layer></meta><plugin filename='f' name='n'><x/></plugin></visual>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Visual& visual = loaded.model().links.at(0).visuals.at(0);
  EXPECT_TRUE(visual.material);
  EXPECT_EQ(visual.transparency, 0.5);
  EXPECT_FALSE(visual.castsShadows);
  EXPECT_EQ(visual.visibilityFlags, 16U);
  EXPECT_EQ(visual.laserRetro, 50);
  EXPECT_EQ(visual.layer, -2);
  EXPECT_EQ(visual.plugins.at(0).filename, "f");
}

TEST(Visual, SaysWhatIsWrong) {
  const auto messages = [](const std::string& content) {
    return loadLink("<visual name='v'><geometry><box/></geometry>\n" + content + "</visual>").messages;
  };
  EXPECT_EQ(messages("<visibility_flags>4294967296</visibility_flags>"),
            Messages{"t.sdf:5:1: error: <visibility_flags> is '4294967296', which is not an integer from 0 to "
                     "4294967295"});
  EXPECT_EQ(messages("<transparency>much</transparency>"),
            Messages{"t.sdf:5:1: error: <transparency> is 'much', which is not a number"});
  EXPECT_EQ(
      messages("<laser_retro>5m</laser_retro>"),
      Messages{
          "t.sdf:5:1: warning: <laser_retro> is '5m', which is not a number | Fortress reads as much of it as it can"});
  EXPECT_EQ(
      messages("<plugin name='n'/>"),
      Messages{"t.sdf:5:1: error: a plugin of visual 'v' of link 'l' of model 'm' has no filename | write <plugin "
               "filename=\"...\" name=\"...\">"});
}

}  // namespace
}  // namespace pongsim::sdf::test
