#include <numbers>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Scope, MeasuresPosesInAnyOrder) {
  const Loaded loaded = loadModel(
      "<pose>7 7 7 0 0 0</pose>"
      "<link name='c'><pose relative_to='b'>1 0 0 0 0 0</pose></link>"
      "<link name='b'><pose relative_to='a' degrees='true'>0 1 0 0 0 90</pose></link>"
      "<link name='a'><pose relative_to='__model__'>0 0 1 0 0 0</pose></link>");
  EXPECT_EQ(loaded.messages, Messages());
  const Quaternion quarter = fromRollPitchYaw(0, 0, std::numbers::pi / 2);
  expectPose(loaded.model().links.at(2).X_ModelLink, {0, 0, 1});
  expectPose(loaded.model().links.at(1).X_ModelLink, {0, 1, 1}, quarter);
  expectPose(loaded.model().links.at(0).X_ModelLink, {0, 2, 1}, quarter);
}

TEST(Scope, MeasuresAFrameInWhatItIsAttachedTo) {
  const Loaded loaded = loadModel(
      "<link name='a'><pose>1 0 0 0 0 0</pose></link><link name='b'><pose>2 0 0 0 0 0</pose></link>"
      "<frame name='f' attached_to='b'><pose>0 1 0 0 0 0</pose></frame>"
      "<frame name='g' attached_to='f'><pose relative_to='a'>0 0 1 0 0 0</pose></frame>"
      "<frame name='h'/>");
  EXPECT_EQ(loaded.messages, Messages());
  const auto& frames = loaded.model().frames;
  expectPose(frames.at(0).X_ModelFrame, {2, 1, 0});
  EXPECT_EQ(frames.at(0).attachedLink, "b");
  expectPose(frames.at(1).X_ModelFrame, {1, 0, 1});
  EXPECT_EQ(frames.at(1).attachedLink, "b");
  expectPose(frames.at(2).X_ModelFrame, {0, 0, 0});
  EXPECT_EQ(frames.at(2).attachedLink, "a");
}

TEST(Scope, AttachesAFrameToTheChildOfAJoint) {
  const Loaded loaded = loadModel(
      "<link name='a'/><link name='b'/><joint name='j' type='fixed'><pose>0 0 1 0 0 0</pose><parent>a</parent>"
      "<child>b</child></joint><frame name='f' attached_to='j'/>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().frames.at(0).attachedLink, "b");
  expectPose(loaded.model().frames.at(0).X_ModelFrame, {0, 0, 1});
}

TEST(Scope, SeesIntoNestedModels) {
  const Loaded loaded = loadModel(
      "<link name='l'><pose relative_to='i::f'>0 0 1 0 0 0</pose></link>"
      "<model name='i'><pose>1 0 0 0 0 0</pose><link name='x'/><frame name='f'><pose>0 1 0 0 0 0</pose></frame>"
      "<model name='k'><pose>0 0 5 0 0 0</pose><link name='y'/></model></model>"
      "<frame name='g' attached_to='i::k::y'/><frame name='h' attached_to='i'/>"
      "<joint name='j' type='fixed'><parent>l</parent><child>i::k::y</child></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(loaded.model().links.at(0).X_ModelLink, {1, 1, 1});
  EXPECT_EQ(loaded.model().frames.at(0).attachedLink, "i::k::y");
  expectPose(loaded.model().frames.at(0).X_ModelFrame, {1, 0, 5});
  EXPECT_EQ(loaded.model().frames.at(1).attachedLink, "i::x");
  EXPECT_EQ(loaded.model().joints.at(0).child, "i::k::y");
  expectPose(loaded.model().joints.at(0).X_ParentJoint, {0, -1, 4});
}

TEST(Scope, DoesNotSeeOutOfANestedModel) {
  EXPECT_EQ(loadModel("<link name='outer'/><model name='i'>\n<link name='x'><pose relative_to='outer'/></link>\n"
                      "<link name='y'><pose relative_to='world'/></link></model>")
                .messages,
            (Messages{"t.sdf:4:22: error: the pose of link 'x' is relative to 'outer', which is not in model 'i'",
                      "t.sdf:5:22: error: the pose of link 'y' is relative to 'world', which is not in model 'i' | a "
                      "model can't refer to the frame of its world"}));
}

TEST(Scope, NamesTheFrameThatIsMeant) {
  EXPECT_EQ(
      loadModel("<link name='chassis'/><frame name='f' attached_to='chasis'/>\n"
                "<frame name='g'><pose relative_to='__modl__'/></frame>")
          .messages,
      (Messages{
          "t.sdf:3:39: error: frame 'f' is attached to 'chasis', which is not in model 'm' | did you mean 'chassis'?",
          "t.sdf:4:23: error: the pose of frame 'g' is relative to '__modl__', which is not in model 'm' | did you "
          "mean '__model__'?"}));
}

TEST(Scope, TellsTheChainOfACycle) {
  const std::string hint = " | one of them must refer to another frame";
  EXPECT_EQ(
      loadModel("<link name='a'><pose relative_to='b'/></link><link name='b'><pose relative_to='c'/></link>"
                "<link name='c'><pose relative_to='a'/></link><link name='d'><pose relative_to='a'/></link>")
          .messages,
      Messages{"t.sdf:3:22: error: link 'a' is relative to 'b', which is relative to 'c', which is relative to 'a'" +
               hint});
  EXPECT_EQ(loadModel("<link name='a'><pose relative_to='a'/></link>").messages,
            Messages{"t.sdf:3:22: error: link 'a' is relative to itself" + hint});
  EXPECT_EQ(loadModel("<link name='a'/><frame name='f' attached_to='g'/><frame name='g' attached_to='f'/>").messages,
            Messages{"t.sdf:3:33: error: frame 'f' is attached to 'g', which is attached to 'f'" + hint});
  EXPECT_EQ(
      loadModel("<link name='a'/><link name='b'><pose relative_to='j'/></link><joint name='j' type='fixed'><parent>a"
                "</parent><child>b</child></joint>")
          .messages,
      Messages{"t.sdf:3:38: error: link 'b' is relative to 'j', which is relative to 'b'" + hint});
}

TEST(Scope, RefusesPosesBeyondAllReach) {
  EXPECT_EQ(loadModel("<link name='a'><pose>1e9 0 0 0 0 0</pose></link>\n"
                      "<link name='b'><pose relative_to='a'>1e9 0 0 0 0 0</pose></link>")
                .messages,
            Messages{"t.sdf:4:22: error: link 'b' is too far from the origin: more than 1e9 m"});
}

TEST(Scope, NamesWhatIsMeantInAnotherModel) {
  EXPECT_EQ(
      loadWorld("<model name='m'><link name='left_wheel'/></model>\n"
                "<frame name='f' attached_to='m::left_wheal'/>\n<frame name='g' attached_to='__root__'/>")
          .messages,
      (Messages{"t.sdf:3:17: error: frame 'f' is attached to 'm::left_wheal', which is not in world 'w' | did you "
                "mean 'm::left_wheel'?",
                "t.sdf:4:17: error: frame 'g' is attached to '__root__', which is not in world 'w' | __root__ can't be "
                "used; the frame of a world is 'world'"}));
}

}  // namespace
}  // namespace pongsim::sdf::test
