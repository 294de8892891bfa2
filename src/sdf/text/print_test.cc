#include "sdf/text/print.hh"

#include "support/fortress_worlds.hh"
#include "support/sdf/load_support.hh"
#include "support/sdf/same_description.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

/// Clears what printing may add without changing the world: the default profile of physics, and elements that are kept
/// as written, whose values are also in the description.
void forgetAdded(Root& root) {
  forgetSensorElements(root);
  for (description::World& world : root.worlds) {
    world.gui.reset();
    if (world.physicsProfiles == std::vector{world.physics}) world.physicsProfiles.clear();
  }
}

/// Expects that a printed file loads to the same description as the file itself.
/// @return Whether the file could be loaded.
bool printsAsItLoads(const std::filesystem::path& file, const assets::Finder& finder) {
  Diagnostics diagnostics;
  Root original = loadFile(file, diagnostics, finder);
  const std::optional<Element> resolved = resolveFile(file, diagnostics, finder);
  EXPECT_EQ(resolved.has_value(), !diagnostics.hasErrors());
  if (!resolved) return false;

  Diagnostics again;
  const std::string text = printDocument(*resolved);
  Root printed = loadText(text, file.string(), again, finder);
  for (const Diagnostic& diagnostic : again.all()) {
    EXPECT_EQ(diagnostic.severity, Severity::kWarning) << format(diagnostic);
  }
  forgetAdded(original);
  forgetAdded(printed);
  EXPECT_TRUE(isSame(original, printed)) << file << "\n" << text;
  return true;
}

class Print : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content, const std::string& version = "1.9") {
    return folder_.write(name, "<sdf version='" + version + "'>\n" + content + "</sdf>");
  }

  pongsim::test::TempFolder folder_;
  assets::Finder finder_ = assets::finderIn({});
};

TEST_F(Print, KeepsWhatIsMergedInPlace) {
  write("inner.sdf", "<model name='inner'><pose>0 0 3 0 0 0</pose><link name='x'/></model>", "1.7");
  write("middle.sdf",
        "<model name='middle'><pose>1 2 3 0.1 0.2 0.3</pose><link name='l'><collision name='c'>"
        "<pose relative_to='__model__'>1 0 0 0 0 0</pose><geometry><sphere/></geometry></collision></link>"
        "<link name='k'/><joint name='j' type='revolute'><parent>l</parent><child>k</child>"
        "<axis><xyz expressed_in='__model__'>1 0 0</xyz></axis></joint><frame name='f'/>"
        "<frame name='g' attached_to='f'><pose relative_to='__model__'>0 1 0 0 0 0</pose></frame>"
        "<include merge='true'><uri>inner.sdf</uri></include>"
        "<include><name>other</name><uri>inner.sdf</uri><pose>5 0 0 0 0 0</pose></include></model>");
  const auto file = write("outer.sdf",
                          "<world name='w'><model name='outer'><pose>7 0 0 0 0 1</pose><link name='own'/>"
                          "<include merge='true'><uri>middle.sdf</uri><placement_frame>k</placement_frame>"
                          "<pose>0 0 1 0 0 0.5</pose></include></model></world>");
  ASSERT_TRUE(printsAsItLoads(file, finder_));
  Diagnostics diagnostics;
  EXPECT_EQ(printDocument(*resolveFile(file, diagnostics, finder_)).find("<include"), std::string::npos);
  const description::Model model = loadFile(file, diagnostics, finder_).worlds.at(0).models.at(0);
  ASSERT_EQ(model.links.size(), 4U);
  // the middle model's frame is where its link k is, and the inner one's above it
  expectPose(model.links[1].X_ModelLink, {0, 0, 1}, fromRollPitchYaw(0, 0, 0.5));
  expectPose(model.links[3].X_ModelLink, {0, 0, 4}, fromRollPitchYaw(0, 0, 0.5));
  expectPose(model.models.at(0).X_ParentModel, Vector3(5 * std::cos(0.5), 5 * std::sin(0.5), 1),
             fromRollPitchYaw(0, 0, 0.5));
}

TEST_F(Print, OfAnOldWorldWhoseNamesHaveSeparatorsLoadsToTheSame) {
  EXPECT_TRUE(
      printsAsItLoads(write("w.sdf",
                            "<world name='w'><model name='a::b'><link name='l'/><link name='in::l'/></model>"
                            "<light name='a::s' type='point'><pose frame='a::b::l'>1 0 0 0 0 0</pose></light></world>",
                            "1.6"),
                      finder_));
}

TEST_F(Print, OfALaterVersionIsInTheNewestOne) {
  const auto file =
      write("w.sdf",
            "<world name='w'><model name='m'><link name='l'><inertial auto='true'><mass>2</mass></inertial>"
            "<collision name='c'><density>10</density><geometry><cone/></geometry></collision></link>"
            "<link name='k'/><joint name='j' type='screw'><parent>l</parent><child>k</child>"
            "<axis><limit/></axis><thread_pitch>3</thread_pitch></joint><plugin filename='f'/></model>"
            "</world>",
            "1.10");
  ASSERT_TRUE(printsAsItLoads(file, finder_));
  Diagnostics diagnostics;
  const std::string text = printDocument(*resolveFile(file, diagnostics, finder_));
  EXPECT_TRUE(diagnostics.all().empty());
  for (const char* part : {"<sdf version=\"1.12\">", "<inertial auto=\"true\">", "<density>10</density>",
                           "<length>1</length>", "<lower>-inf</lower>", "<plugin filename=\"f\"/>"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
}

TEST_F(Print, KeepsTheThreadsOfScrewsOfAnyVersion) {
  const std::string model =
      "<model name='m'><link name='l'/><link name='k'/><joint name='j' type='screw'><parent>l</parent>"
      "<child>k</child><axis/><thread_pitch>3</thread_pitch></joint></model>";
  write("old.sdf", model, "1.9");
  write("new.sdf", model, "1.10");
  const std::string world =
      "<world name='w'><include><uri>old.sdf</uri><name>a</name></include><include><uri>new.sdf</uri></include>"
      "</world>";
  for (const char* version : {"1.9", "1.12"}) {
    const auto file = write("w.sdf", world, version);
    EXPECT_TRUE(printsAsItLoads(file, finder_));
    Diagnostics diagnostics;
    const auto models = loadFile(file, diagnostics, finder_).worlds.at(0).models;
    EXPECT_EQ(models.at(0).joints.at(0).threadPitch, 3);
    EXPECT_NEAR(models.at(1).joints.at(0).threadPitch, -2 * M_PI / 3, 1e-12);
  }
}

TEST_F(Print, KeepsModelsLightsAndPluginsOfOtherFiles) {
  write("m.sdf",
        "<model name='m'><link name='a::l'/><plugin filename='f' name='n'>a &lt; b<x y='&quot;'/></plugin></model>",
        "1.6");
  write("s.sdf", "<light name='s' type='point'/>");
  EXPECT_TRUE(printsAsItLoads(
      write("w.sdf",
            "<world name='w'><include><uri>m.sdf</uri><plugin filename='g' name='n'/></include>"
            "<include><uri>s.sdf</uri><pose>1 0 0 0 0 0</pose></include><plugin filename='p' name='n'>text"
            "</plugin><include><name>second</name><uri>m.sdf</uri></include></world>"),
      finder_));
}

TEST_F(Print, MakesAddressesOfWhatIsIncludedAbsolute) {
  folder_.write("models/m/meshes/a.dae", "x");
  write("models/m/m.sdf",
        "<model name='m'><link name='l'><visual name='v'><geometry><mesh><uri>meshes/a.dae</uri></mesh></geometry>"
        "<material><diffuse>1 1 1 1</diffuse></material></visual></link></model>");
  const auto file = write("w.sdf", "<world name='w'><include><uri>models/m/m.sdf</uri></include></world>");
  Diagnostics diagnostics;
  const std::string text = printDocument(*resolveFile(file, diagnostics, finder_));
  EXPECT_NE(text.find("<uri>" + (folder_.path() / "models/m/meshes/a.dae").string() + "</uri>"), std::string::npos)
      << text;
  EXPECT_NE(text.find("<diffuse>1 1 1 1</diffuse>"), std::string::npos);
}

TEST_F(Print, OfAllFortressWorldsLoadsToTheSame) {
  const auto folder = pongsim::test::fortressWorlds();
  if (!folder) GTEST_SKIP() << "Fortress's worlds are not there";
  const assets::Finder finder = assets::finderIn({{*folder / "test/models"}, "/nowhere"});
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder)) {
    if (entry.path().extension() == ".sdf" && printsAsItLoads(entry.path(), finder)) ++count;
  }
  EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace pongsim::sdf::test
