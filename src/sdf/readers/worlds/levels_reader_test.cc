#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

constexpr const char* kModels =
    "<model name='robot'><link name='l'/></model><model name='tile'><link name='l'/></model>";

/// Loads a plugin with that content, its first character in line 3, column 1.
Loaded loadLevels(const std::string& content, const std::string& name = "gz::sim") {
  return loadWorld(std::string(kModels) + "<light name='sun' type='point'/><plugin filename='dummy' name='" + name +
                   "'>\n" + content + "\n</plugin>");
}

const std::string kBox = "<geometry><box><size>1 2 3</size></box></geometry>";

TEST(Levels, AreRead) {
  const std::string content = "<performer name='p'><ref>robot</ref>" + kBox + "</performer><level name='l'>" + kBox +
                              "<pose>4 5 6 0 0 0</pose><buffer>7</buffer><ref>tile</ref><ref>sun</ref></level>";
  for (const char* name : {"gz::sim", "ignition::gazebo"}) {
    const Loaded loaded = loadLevels(content, name);
    EXPECT_EQ(loaded.messages, Messages());
    const description::LevelPlan& plan = loaded.world().levels;
    EXPECT_TRUE(plan.isGiven);
    ASSERT_EQ(plan.performers.size(), 1U);
    EXPECT_EQ(plan.performers[0].name, "p");
    EXPECT_EQ(plan.performers[0].ref, "robot");
    EXPECT_EQ(plan.performers[0].size, Vector3(1, 2, 3));
    ASSERT_EQ(plan.levels.size(), 1U);
    EXPECT_EQ(plan.levels[0].name, "l");
    EXPECT_EQ(plan.levels[0].center, Vector3(4, 5, 6));
    EXPECT_EQ(plan.levels[0].size, Vector3(1, 2, 3));
    EXPECT_EQ(plan.levels[0].buffer, 7);
    ASSERT_EQ(plan.levels[0].members.size(), 2U);
    EXPECT_EQ(plan.levels[0].members[0].name, "tile");
    EXPECT_EQ(plan.levels[0].members[1].name, "sun");
  }
}

TEST(Levels, AreThoseOfAPluginOfThatNameOnly) {
  const Loaded loaded = loadLevels("<level name='l'/>", "gz::sim::systems::Physics");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_FALSE(loaded.world().levels.isGiven);
}

TEST(Levels, OfASecondPluginAreLeftOut) {
  const Loaded loaded = loadLevels("</plugin>\n<plugin filename='dummy' name='gz::sim'><level name='l'/>");
  EXPECT_EQ(
      loaded.messages,
      (Messages{"t.sdf:4:1: warning: the levels and performers of this plugin are ignored: those of line 2 are used"}));
}

TEST(Levels, WithoutABoxAreLeftOut) {
  const std::string hint = " | write <geometry><box><size>X Y Z</size></box></geometry>";
  const Loaded loaded = loadLevels(
      "<level name='a'><ref>tile</ref></level>\n"
      "<level name='b'><geometry><sphere><radius>1</radius></sphere></geometry><ref>tile</ref></level>\n"
      "<level name='c'><geometry><sphere><radius>1</radius></sphere><box/></geometry><ref>tile</ref></level>\n"
      "<performer name='p'><ref>robot</ref></performer>");
  EXPECT_EQ(loaded.messages, (Messages{"t.sdf:3:1: warning: level 'a' has no <geometry>: it is ignored" + hint,
                                       "t.sdf:4:17: warning: level 'b' is not a box: it is ignored" + hint,
                                       "t.sdf:5:17: warning: level 'c' has several shapes: it is ignored" + hint,
                                       "t.sdf:6:1: warning: performer 'p' has no <geometry>: it is ignored" + hint}));
  EXPECT_TRUE(loaded.world().levels.levels.empty());
  EXPECT_TRUE(loaded.world().levels.performers.empty());
}

TEST(Levels, WithABoxThatCanNotBeAreAnError) {
  const Loaded loaded =
      loadLevels("<level name='a'><geometry><box><size>1 0 1</size></box></geometry><ref>tile</ref></level>");
  EXPECT_EQ(loaded.messages,
            (Messages{"t.sdf:3:32: error: <size> is '1 0 1', which is not three finite numbers above zero"}));
}

TEST(Levels, NameWhatIsThere) {
  const Loaded loaded = loadLevels("<level name='l'>" + kBox +
                                   "<ref>tlie</ref>\n<ref/><ref>tile</ref><ref>tile</ref></level>\n"
                                   "<level name='m'>" +
                                   kBox + "</level>");
  EXPECT_EQ(loaded.messages, (Messages{"t.sdf:3:67: warning: level 'l' names 'tlie', which is not a model, light or "
                                       "actor of the world (nor is another name of the levels) | did you mean 'tile'?",
                                       "t.sdf:4:22: warning: level 'l' names 'tile' twice",
                                       "t.sdf:5:1: warning: level 'm' is empty | write <ref>MODEL</ref>"}));
  ASSERT_EQ(loaded.world().levels.levels.size(), 2U);
  EXPECT_EQ(loaded.world().levels.levels[0].members.size(), 1U);
}

TEST(Levels, WhoseMembersAreAllMissingAreWarnedOfOnce) {
  std::string levels;
  for (const char* name : {"a", "b", "c"})
    levels += "<level name='" + std::string(name) + "'>" + kBox + "<ref>gone</ref><ref/></level>";
  EXPECT_EQ(loadLevels(levels).messages,
            (Messages{"t.sdf:3:67: warning: level 'a' names 'gone', which is not a model, light or actor of the world "
                      "(nor are 5 other names of the levels)"}));
}

TEST(Levels, OfOneNameAreWarnedOf) {
  const std::string level = "<level name='l'>" + kBox + "<ref>tile</ref></level>\n";
  const Loaded loaded = loadLevels(level + level + "<level>" + kBox + "<ref>tile</ref></level>");
  EXPECT_EQ(loaded.messages,
            (Messages{"t.sdf:4:1: warning: there is a level 'l' in line 3 already: messages can't distinguish them",
                      "t.sdf:5:1: warning: a level has no name | write <level name=\"...\">"}));
  EXPECT_EQ(loaded.world().levels.levels.size(), 3U);
}

TEST(Levels, HaveNoNegativeBufferAndAreNotTurned) {
  const Loaded loaded = loadLevels("<level name='l'>" + kBox + "<ref>tile</ref>\n<buffer>-1</buffer>\n" +
                                   "<pose>0 0 0 0 0 1</pose></level>");
  EXPECT_EQ(loaded.messages, (Messages{"t.sdf:4:1: warning: the <buffer> of level 'l' is negative: 0 is used | the "
                                       "level is unloaded when the performer is this many metres outside it",
                                       "t.sdf:5:1: warning: the box of level 'l' is not rotated: it is aligned with "
                                       "the axes of the world, as in Fortress"}));
  EXPECT_EQ(loaded.world().levels.levels.at(0).buffer, 0);
}

TEST(Levels, DoNotTakePerformersAway) {
  const Loaded loaded = loadLevels("<performer name='p'><ref>robot</ref>" + kBox + "</performer>\n<level name='l'>" +
                                   kBox + "<ref>robot</ref></level>");
  EXPECT_EQ(
      loaded.messages,
      Messages{"t.sdf:4:67: warning: level 'l' names 'robot', which is a performer: performers are always loaded"});
  EXPECT_TRUE(loaded.world().levels.levels.at(0).members.empty());
}

TEST(Performers, AreModelsOrActorsEachOnce) {
  const Loaded loaded =
      loadLevels("<performer name='p'><ref>robto</ref>" + kBox + "</performer>\n<performer name='q'>" + kBox +
                 "</performer>\n<performer name='r'><ref>robot</ref>" + kBox +
                 "</performer>\n<performer name='s'><ref>robot</ref>" + kBox +
                 "</performer>\n<performer name='t'><ref>sun</ref>" + kBox + "</performer>");
  EXPECT_EQ(loaded.messages,
            (Messages{"t.sdf:3:21: warning: performer 'p' names 'robto', which is not a model or actor of the world: "
                      "it is ignored | did you mean 'robot'?",
                      "t.sdf:4:1: warning: performer 'q' has no <ref>: it is ignored | write <ref>MODEL</ref>",
                      "t.sdf:6:21: warning: performer 's' is left out: 'robot' is already performer 'r' in line 5",
                      "t.sdf:7:21: warning: performer 't' names 'sun', which is not a model or actor of the world: it "
                      "is ignored"}));
  ASSERT_EQ(loaded.world().levels.performers.size(), 1U);
  EXPECT_EQ(loaded.world().levels.performers[0].name, "r");
}

TEST(Levels, WarnOfElementsThatNobodyKnows) {
  const Loaded loaded = loadLevels("<levl/>\n<level name='l'>" + kBox + "<ref>tile</ref><bufer>1</bufer></level>\n" +
                                   "<performer name='p'><ref>robot</ref>" + kBox + "<pose/></performer>");
  EXPECT_EQ(loaded.messages,
            (Messages{"t.sdf:3:1: warning: <levl> is unknown in the levels plugin | did you mean 'level'?",
                      "t.sdf:4:82: warning: <bufer> is unknown in <level> | did you mean 'buffer'?",
                      "t.sdf:5:87: warning: <pose> is unknown in <performer>"}));
}

}  // namespace
}  // namespace pongsim::sdf::test
