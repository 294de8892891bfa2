#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Loader, ReadsAFileAndNamesItAsGiven) {
  const pongsim::test::TempFolder folder;
  const std::filesystem::path file = folder.write("a.sdf", "<sdf version='1.9'>\n<world name='w'/></sdf>");
  Diagnostics diagnostics;
  const Root root = loadFile(file, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  ASSERT_EQ(root.worlds.size(), 1U);
  EXPECT_EQ(root.worlds[0].name, "w");
  EXPECT_EQ(*root.worlds[0].position.file, file.string());
  EXPECT_EQ(root.worlds[0].position.line, 2);
}

TEST(Loader, ReportsAFileThatIsMissing) {
  Diagnostics diagnostics;
  loadFile("/nosuch/a.sdf", diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(format(diagnostics.all()[0]),
            "/nosuch/a.sdf: error: no such file\n  hint: there is no folder '/nosuch' either");
}

TEST(Loader, ReadsAllWorldsOfAFile) {
  const Loaded loaded = load("<sdf version='1.9'><world name='a'/><world name='b'/></sdf>");
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_EQ(loaded.root.worlds.size(), 2U);
  EXPECT_EQ(loaded.root.worlds[1].name, "b");
  EXPECT_EQ(
      load("<sdf version='1.9'><world name='a'/>\n<world name='a'/></sdf>").messages,
      Messages{"t.sdf:2:1: error: world 'a' has the same name as another world of this file | the first one is in "
               "line 1"});
}

TEST(Loader, SaysWhatTheFileIsInstead) {
  EXPECT_EQ(load("<svg/>").messages,
            Messages{"t.sdf:1:1: error: the file begins with <svg>, not with <sdf> or <robot>"});
  EXPECT_EQ(load("<sdf version='1.9'/>").messages,
            Messages{"t.sdf:1:1: error: there is no <world> and no <model> in this file"});
}

TEST(Loader, ReadsModelsAndLightsOutsideOfAWorld) {
  const Loaded loaded = load(
      "<sdf version='1.9'><model name='m'><pose>0 0 1 0 0 0</pose><link name='l'/><joint name='j' type='fixed'>"
      "<parent>world</parent><child>l</child></joint></model><light name='s' type='point'/></sdf>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_TRUE(loaded.root.worlds.empty());
  ASSERT_EQ(loaded.root.models.size(), 1U);
  expectPose(loaded.root.models[0].X_ParentModel, {0, 0, 1});
  expectPose(loaded.root.models[0].joints.at(0).X_ParentJoint, {0, 0, 1});
  EXPECT_EQ(loaded.root.lights.at(0).name, "s");
  EXPECT_EQ(load("<sdf version='1.9'>\n<actor name='a'/></sdf>").messages, Messages());
}

TEST(Loader, ChecksTheVersion) {
  const auto messages = [](const std::string& attribute) {
    return load("<sdf " + attribute + "><world name='w'/></sdf>").messages;
  };
  EXPECT_EQ(messages("version='1.4'"), Messages());
  EXPECT_EQ(messages(""), Messages{"t.sdf:1:1: error: <sdf> has no version | write <sdf version=\"1.9\">"});
  EXPECT_EQ(messages("version='x'"),
            Messages{"t.sdf:1:6: error: 'x' is not a version of SDF | the versions are 1.4 to 1.12"});
  for (const char* newer : {"version='1.10'", "version='1.11'", "version='1.12'"}) {
    EXPECT_EQ(messages(newer), Messages()) << newer;
  }
  EXPECT_EQ(messages("version='1.13'"),
            Messages{"t.sdf:1:6: warning: SDF 1.13 is not supported: reading the file as SDF 1.12"});
}

TEST(Loader, TellsAllMistakesInOneGoInTheOrderOfTheFile) {
  const Loaded loaded = loadWorld(
      "<joint name='j' type='fixed'><parent>m</parent><child>nosuch</child></joint>\n"
      "<model name='m'>\n"
      "<pose>a b c</pose>\n"
      "<link/>\n"
      "<link name='l'><inertial><mass>-1</mass></inertial><colision/></link>\n"
      "</model>");
  EXPECT_EQ(
      loaded.messages,
      (Messages{"t.sdf:2:48: error: joint 'j' names child link 'nosuch', which is not in world 'w'",
                "t.sdf:4:1: error: <pose> is 'a b c', which is not a pose: six finite numbers, x y z roll pitch yaw",
                "t.sdf:5:1: error: <link> in model 'm' has no name | write <link name=\"...\">",
                "t.sdf:6:26: error: <mass> is '-1', which is not a finite number above zero",
                "t.sdf:6:52: warning: <colision> is unknown in <link> | did you mean 'collision'?"}));
}

}  // namespace
}  // namespace pongsim::sdf::test
