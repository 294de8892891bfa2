#include "pongsim/world_edits.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <string>
#include <vector>

#include "support/environment_variable.hh"
#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim {
namespace {

using test::RunningWorld;

// the folder with the test's plugin
const test::EnvironmentVariable kFolder("PONGSIM_PLUGIN_PATH", PONGSIM_EDITING_FOLDER);

const std::string kEditor =
    std::string("<plugin filename='editing' name='test::Editing'>") +
    "<sdf version='1.9'><model name='crumb'><static>true</static><link name='l'/></model></sdf></plugin>";

std::string robot(const std::string& name) {
  return "<model name='" + name + "'><static>true</static><link name='l'/>" + kEditor + "</model>";
}

TEST(WorldEdits, InsertNoLibraryByItsPath) {
  const std::string nothing;
  RunningWorld world(nothing);
  const std::string file = PONGSIM_EDITING_FOLDER "/libediting.so";
  for (const char* leave : {"0", "1"}) {
    const test::EnvironmentVariable allowed("PONGSIM_ALLOW_PLUGIN_PATHS", leave);
    Diagnostics diagnostics;
    InsertOptions renamed;
    renamed.name = std::string("m") + leave;
    const auto model = world.simulation().insertText(
        "<sdf version='1.9'><model name='m'><static>true</static><link name='l'/><plugin filename='" + file +
            "' name='test::Editing'/></model></sdf>",
        "m.sdf", renamed, diagnostics);
    EXPECT_TRUE(model);
    ASSERT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(diagnostics.all()[0].message,
              "plugin '" + file + "' is a path, which is not allowed here: it is left out");
  }
}

TEST(WorldEdits, AreThoseOfALibraryByItsPathOnlyWithLeave) {
  const std::string world =
      RunningWorld::textOf("<plugin filename='" PONGSIM_EDITING_FOLDER "/libediting.so' name='test::Editing'/>");
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText(world, "w.sdf", {}, diagnostics), nullptr);
  ASSERT_FALSE(diagnostics.all().empty());
  EXPECT_NE(diagnostics.all()[0].hint.find("--allow-plugin-paths"), std::string::npos);
  Diagnostics allowed;
  Simulation::fromText(world, "w.sdf", {.allowPluginPaths = true}, allowed);
  for (const Diagnostic& diagnostic : allowed.all()) EXPECT_EQ(diagnostic.message.find("is a path"), std::string::npos);
}

class WorldEditsTest : public testing::Test {
 protected:
  explicit WorldEditsTest(const std::string& content = kEditor) : world_(content) { world_.listen("/edited", said_); }

  void tell(const std::string& what) {
    ignition::msgs::StringMsg message;
    message.set_data(what);
    world_.tell("/edit", message);
  }
  /// @return Messages received since the last call.
  std::vector<std::string> said() {
    world_.simulation().transport().dispatch();
    std::vector<std::string> texts;
    for (const auto& message : said_) texts.push_back(message.data());
    said_.clear();
    return texts;
  }
  bool has(const std::string& model) { return world_.simulation().world().model(model).has_value(); }

  RunningWorld world_;
  std::vector<ignition::msgs::StringMsg> said_;
};

using Said = std::vector<std::string>;

TEST_F(WorldEditsTest, InsertWhatWasReadBefore) {
  tell("template a");
  tell("template b");
  tell("template a");
  world_.simulation().step();
  const Said all = said();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], "there is a");
  EXPECT_EQ(all[1], "there is b");
  EXPECT_TRUE(all[2].starts_with("world.sdf:1:") && all[2].ends_with(": there is a 'a' in the world already"))
      << all[2];
  EXPECT_EQ(world_.model("a").pose().position.x(), 3);
}

TEST_F(WorldEditsTest, AreCarriedOutInTheStepInWhichTheyAreAskedFor) {
  tell("step template a");
  EXPECT_FALSE(has("a"));
  world_.simulation().step();
  EXPECT_TRUE(has("a"));
}

TEST_F(WorldEditsTest, AreCarriedOutWhilePaused) {
  tell("template a");
  world_.simulation().stepPaused();
  EXPECT_TRUE(has("a"));
}

TEST_F(WorldEditsTest, InsertTextsFilesAndCopies) {
  tell(
      "text <sdf version='1.9'><model name='t'><static>1</static><pose>7 0 0 0 0 0</pose><link "
      "name='l'/></model></sdf>");
  world_.simulation().step();
  tell("copy t");
  tell("file /no/such/file.sdf");
  world_.simulation().step();
  const Said all = said();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], "there is t");
  EXPECT_EQ(all[1], "there is t_0");
  EXPECT_NE(all[2].find("/no/such/file.sdf"), std::string::npos) << all[2];
  EXPECT_EQ(world_.model("t_0").pose().position.x(), 7);
}

TEST_F(WorldEditsTest, InsertTheFileOfAModelsFolder) {
  const test::TempFolder folder;
  folder.write("cup/model.config", "<model><name>cup</name><sdf version='1.9'>cup.sdf</sdf></model>");
  folder.write("cup/cup.sdf", "<sdf version='1.9'><model name='cup'><static>1</static><link name='l'/></model></sdf>");
  tell("file " + (folder.path() / "cup").string());
  tell("file " + folder.path().string());
  world_.simulation().step();
  const Said all = said();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0], "there is cup");
  EXPECT_NE(all[1].find("model.config"), std::string::npos) << all[1];
}

TEST_F(WorldEditsTest, ReadWhatIsInsertedLater) {
  tell(
      "read <sdf version='1.9'><model name='r'><static>1</static><link name='l'><collision name='c'><geometry><mesh>"
      "<uri>model://no/such.dae</uri></mesh></geometry></collision></link></model></sdf>");
  tell("read <sdf version='1.9'><model name='s'><lonk/>");
  tell("find /no/such/folder");
  tell("find /");
  world_.simulation().step();
  const Said all = said();
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0], "read r with 1 warnings");
  EXPECT_TRUE(all[1].starts_with("read:1:")) << all[1];
  EXPECT_EQ(all[2], "nothing");
  EXPECT_EQ(all[3], "/");
  EXPECT_EQ(all[4], "there is r");
  EXPECT_TRUE(has("r"));
}

TEST_F(WorldEditsTest, GiveACopyTheFirstFreeName) {
  tell("template a");
  world_.simulation().step();
  for (int i = 0; i < 3; ++i) tell("copy a");
  world_.simulation().step();
  for (const char* what : {"remove a_1", "copy a", "copy a"}) tell(what);
  world_.simulation().step();
  EXPECT_EQ(said(), (Said{"there is a", "there is a_0", "there is a_1", "there is a_2", "it has gone", "there is a_1",
                          "there is a_3"}));
  Diagnostics diagnostics;
  world_.simulation().reset(diagnostics);
  tell("template a");
  world_.simulation().step();
  tell("copy a");
  world_.simulation().step();
  EXPECT_EQ(said(), (Said{"there is a", "there is a_0"}));
}

TEST_F(WorldEditsTest, RemoveModels) {
  tell("template a");
  world_.simulation().step();
  tell("remove a");
  tell("remove a");
  world_.simulation().step();
  EXPECT_FALSE(has("a"));
  EXPECT_EQ(said(), (Said{"there is a", "it has gone", "the model no longer exists"}));
}

TEST_F(WorldEditsTest, RemoveModelsBetweenInsertionsInTheirOrder) {
  for (const char* name : {"a", "b", "c"}) tell(std::string("template ") + name);
  world_.simulation().step();
  for (const char* what : {"remove a", "remove c", "remove c", "template a", "remove b", "template b"}) tell(what);
  said();
  world_.simulation().step();
  EXPECT_EQ(said(), (Said{"it has gone", "it has gone", "the model no longer exists", "there is a", "it has gone",
                          "there is b"}));
  EXPECT_TRUE(has("a") && has("b"));
  EXPECT_FALSE(has("c"));
}

TEST_F(WorldEditsTest, WarnOfARefusalThatNobodyIsTold) {
  tell("template a");
  world_.simulation().step();
  testing::internal::CaptureStderr();
  tell("silent template a");
  world_.simulation().step();
  const std::string text = testing::internal::GetCapturedStderr();
  const std::size_t place = text.find("a model can't be inserted: world.sdf:1:");
  ASSERT_NE(place, std::string::npos) << text;
  EXPECT_NE(text.find(": there is a 'a' in the world already", place), std::string::npos) << text;
}

TEST_F(WorldEditsTest, SwitchASystemOffWhoseAnswerThrows) {
  testing::internal::CaptureStderr();
  tell("template bad");
  world_.simulation().step();
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_NE(text.find("failed in the answer to an edit: it is bad; it is switched off"), std::string::npos) << text;
  EXPECT_TRUE(has("bad"));
}

TEST_F(WorldEditsTest, AreForgottenByAReset) {
  tell("template a");
  world_.simulation().transport().dispatch();
  Diagnostics diagnostics;
  world_.simulation().reset(diagnostics);
  world_.simulation().step();
  EXPECT_FALSE(has("a"));
  EXPECT_EQ(said(), Said{});
}

class WorldEditsOfModels : public WorldEditsTest {
 protected:
  WorldEditsOfModels() : WorldEditsTest(robot("first") + robot("second")) {}
};

// Both systems receive the message; the request of the first removes the model of the second.
TEST_F(WorldEditsOfModels, EndWithTheirSystem) {
  tell("remove second");
  world_.simulation().step();
  EXPECT_FALSE(has("second"));
  EXPECT_EQ(said(), Said{"it has gone"});
  tell("remove first");
  world_.simulation().step(2);
  EXPECT_FALSE(has("first"));
  EXPECT_EQ(said(), Said{});
}

// Each system removes its own model: a request of a system that no longer exists must not remain.
TEST_F(WorldEditsOfModels, RemoveTheirOwnModelsInOneStep) {
  tell("remove itself");
  world_.simulation().step();
  EXPECT_FALSE(has("first"));
  EXPECT_FALSE(has("second"));
  EXPECT_EQ(said(), Said{});
}

/// @return Diagnostics of a world whose editing system reads this SDF.
std::vector<std::string> complaintsAbout(const std::string& sdf) {
  return RunningWorld::complaintsAbout(std::string("<plugin filename='editing") + "' name='test::Editing'>" + sdf +
                                       "</plugin>");
}

TEST(WorldEditsRead, SaysWhatIsWrongWithAModel) {
  const auto endsWith = [](const std::vector<std::string>& said, const std::string& end) {
    EXPECT_TRUE(!said.empty() && said.back().ends_with(end)) << (said.empty() ? "nothing" : said.back());
  };
  endsWith(complaintsAbout("<sdf version='1.9'><world name='w'/></sdf>"), " is left out: there is no model to insert");
  endsWith(complaintsAbout("<sdf version='1.9'><model name='m'/></sdf>"), " is left out: model 'm' has no link");
  EXPECT_EQ(complaintsAbout("<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>"), Said{});
}

TEST(WorldEditsRead, SaysWhereItIsAndAllElseAsWarnings) {
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText(RunningWorld::textOf(std::string("\n<plugin filename='editing") +
                                                      "' name='test::Editing'><sdf version='1.9'>\n<model name='m'>"
                                                      "\n<link name='l'><mass>1</mass></link>\n<link name='l'/>"
                                                      "</model></sdf></plugin>"),
                                 "world.sdf", {}, diagnostics),
            nullptr);
  std::vector<int> lines;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    EXPECT_EQ(diagnostic.severity, Severity::kWarning);
    lines.push_back(diagnostic.position.line);
  }
  EXPECT_EQ(lines, (std::vector<int>{4, 5}));
}

}  // namespace
}  // namespace pongsim
