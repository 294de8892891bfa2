#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Actor, IsReadWhole) {
  const pongsim::test::TempFolder folder;
  const std::string file = folder.write("walk.dae", "x").string();
  const Loaded loaded =
      loadWorld("<actor name='a'><pose relative_to='f'>0 0 1 0 0 0</pose><skin><filename>" + file +
                "</filename><scale>2</scale></skin><animation name='walk'><filename>" + file +
                "</filename><scale>3</scale><interpolate_x>true</interpolate_x></animation>" +
                "<script><loop>false</loop><delay_start>1.5</delay_start><auto_start>0</auto_start>" +
                "<trajectory id='4' type='walk' tension='0.5'><waypoint><time>0</time>" +
                "<pose>1 0 0 0 0 0</pose></waypoint><waypoint><time>2</time><pose>1 2 0 0 0 0</pose>" +
                "</waypoint></trajectory></script><plugin filename='f' name='n'/></actor>" +
                "<frame name='f'><pose>7 0 0 0 0 0</pose></frame>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Actor& actor = loaded.world().actors.at(0);
  EXPECT_EQ(actor.name, "a");
  expectPose(actor.X_WorldActor, {7, 0, 1});
  EXPECT_EQ(actor.skin, (description::ActorFile{file, file, 2}));
  EXPECT_EQ(actor.animations.at(0).name, "walk");
  EXPECT_EQ(actor.animations.at(0).source.scale, 3);
  EXPECT_TRUE(actor.animations.at(0).followsPath);
  EXPECT_FALSE(actor.loops || actor.startsByItself);
  EXPECT_EQ(actor.startDelay, 1.5);
  const description::Trajectory& trajectory = actor.trajectories.at(0);
  EXPECT_EQ(trajectory.id, 4);
  EXPECT_EQ(trajectory.type, "walk");
  EXPECT_EQ(trajectory.tension, 0.5);
  ASSERT_EQ(trajectory.waypoints.size(), 2U);
  EXPECT_EQ(trajectory.waypoints[1].time, 2);
  expectPose(trajectory.waypoints[1].X_ActorWaypoint, {1, 2, 0});
  EXPECT_EQ(actor.plugins.size(), 1U);
}

TEST(Actor, MayStandAtTheRoot) {
  const Loaded loaded = load("<sdf version='1.9'>\n<actor name='a'/></sdf>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.root.actors.at(0).name, "a");
}

TEST(Actor, SaysWhatIsWrong) {
  EXPECT_EQ(loadWorld("<actor name='a'><skin><filename>/no/s.dae</filename><scale>-1</scale></skin>\n"
                      "<animation name='x'/><animation name='x'/></actor><actor name='a'/>")
                .messages,
            (Messages{"t.sdf:2:23: warning: <filename> '/no/s.dae' is not found | looked for it at /no/s.dae; set "
                      "PONGSIM_RESOURCE_PATH to search more folders",
                      "t.sdf:2:53: error: <scale> is '-1', which is not a finite number above zero",
                      "t.sdf:3:22: error: animation 'x' has the same name as another animation of actor 'a' of world "
                      "'w' | the first one is in line 3",
                      "t.sdf:3:51: error: actor 'a' has the same name as another actor of world 'w' | the first one is "
                      "in line 2"}));
}

TEST(Actor, ShowsWhatItsLinksShow) {
  const Loaded loaded = loadWorld(
      "<actor name='a'><link name='l'><pose>1 0 0 0 0 0</pose><visual name='v'><pose>0 2 0 0 0 0</pose>"
      "<geometry><sphere><radius>0.5</radius></sphere></geometry></visual></link><link name='m'/></actor>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Actor& actor = loaded.world().actors.at(0);
  ASSERT_EQ(actor.visuals.size(), 1U);
  EXPECT_EQ(actor.visuals[0].name, "v");
  expectPose(actor.visuals[0].X_LinkVisual, {1, 2, 0});
  EXPECT_EQ(actor.visuals[0].geometry, description::Geometry(description::Sphere{0.5}));
  EXPECT_EQ(loadWorld("<actor name='a'><link name='l'><pose relative_to='x'/></link></actor>").messages,
            Messages{"t.sdf:2:38: warning: frames have no effect in actors: the pose is used as it is"});
}

}  // namespace
}  // namespace pongsim::sdf::test
