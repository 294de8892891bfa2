#include "plugin/loader.hh"

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/temp_folder.hh"

namespace pongsim::plugin {
namespace {

constexpr auto kOptional = Loader::Need::kOptional, kRequired = Loader::Need::kRequired;

description::Plugin plugin(std::string filename, std::string className = "") {
  description::Plugin made;
  made.filename = std::move(filename);
  made.className = std::move(className);
  made.sdf.position = {std::make_shared<const std::string>("world.sdf"), 12, 5};
  return made;
}

class LoaderTest : public testing::Test {
 protected:
  std::string onlyLine() const {
    EXPECT_EQ(diagnostics_.all().size(), 1U);
    return diagnostics_.all().empty() ? "" : format(diagnostics_.all().front());
  }

  Loader loader_{{PONGSIM_TEST_PLUGINS}};
  Diagnostics diagnostics_;
};

TEST_F(LoaderTest, FindsASystemByAnyOfItsNames) {
  for (const char* filename : {"ignition-gazebo-counting-system", "libpongsim-counting-system.so"}) {
    for (const char* className : {"test::Counting", "test::Counter", ""}) {
      EXPECT_NE(loader_.load(plugin(filename, className), Loader::Paths::kNeedLeave, kOptional, diagnostics_), nullptr)
          << filename << " " << className;
    }
  }
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(LoaderTest, OpensAPathOnlyWhereThatIsAllowed) {
  const std::string file = std::string(PONGSIM_TEST_PLUGINS) + "/libpongsim-counting-system.so";
  EXPECT_EQ(loader_.load(plugin(file), Loader::Paths::kNeedLeave, kOptional, diagnostics_), nullptr);
  EXPECT_EQ(onlyLine(), "world.sdf:12:5: warning: plugin '" + file +
                            "' is a path, which is not allowed here: it is left out\n"
                            "  hint: if you trust this world, run it with --allow-plugin-paths; or name the library "
                            "alone, and its folder in PONGSIM_PLUGIN_PATH");
  // also one below a folder of systems, and one that could be reached from there
  for (const std::string& path : {std::string("/proc/self/cwd/libx.so"), std::string("./libpongsim-counting-system.so"),
                                  std::string("../plugins/libpongsim-counting-system.so")}) {
    diagnostics_ = Diagnostics();
    EXPECT_EQ(loader_.load(plugin(path), Loader::Paths::kNever, kOptional, diagnostics_), nullptr);
    EXPECT_NE(onlyLine().find("hint: only the world that a run starts with may name paths"), std::string::npos);
  }
  diagnostics_ = Diagnostics();
  EXPECT_NE(loader_.load(plugin(file), Loader::Paths::kAllowed, kOptional, diagnostics_), nullptr);
  EXPECT_EQ(loader_.load(plugin("/nowhere/libx.so"), Loader::Paths::kAllowed, kRequired, diagnostics_), nullptr);
  EXPECT_NE(onlyLine().find("plugin '/nowhere/libx.so' was not found"), std::string::npos);
}

TEST_F(LoaderTest, NamesTheNearestClass) {
  EXPECT_EQ(loader_.load(plugin("pongsim-counting-system", "test::Countin"), Loader::Paths::kNeedLeave, kOptional,
                         diagnostics_),
            nullptr);
  EXPECT_EQ(onlyLine(),
            "world.sdf:12:5: warning: plugin 'pongsim-counting-system' has no class 'test::Countin': it is left out\n"
            "  hint: did you mean 'test::Counting'?");
}

TEST_F(LoaderTest, NamesTheNearestSystem) {
  EXPECT_EQ(
      loader_.load(plugin("ignition-gazebo-dif-drive-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
      nullptr);
  EXPECT_EQ(onlyLine(),
            "world.sdf:12:5: warning: plugin 'ignition-gazebo-dif-drive-system' was not found: it is left out\n"
            "  hint: did you mean 'diff-drive'?");
}

TEST_F(LoaderTest, TellsWhereItLookedForWhatIsLikeNothing) {
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(loader_.load(plugin("libMyVeryOwnPlugin.so"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
              nullptr);
  EXPECT_TRUE(diagnostics_.all().empty());
  loader_.reportMissing(diagnostics_);
  loader_.reportMissing(diagnostics_);
  EXPECT_EQ(onlyLine(), std::string("world.sdf:12:5: warning: plugin 'libMyVeryOwnPlugin.so' was not found: it is left "
                                    "out\n  hint: looked in ") +
                            PONGSIM_TEST_PLUGINS + "; PONGSIM_PLUGIN_PATH adds folders");
}

TEST_F(LoaderTest, SumsUpThoseThatAreLikeNothing) {
  for (const char* filename : {"libMyVeryOwnPlugin.so", "libFleetReferee.so", "libUnderseaCurrents.so"})
    loader_.load(plugin(filename), Loader::Paths::kNeedLeave, kOptional, diagnostics_);
  loader_.reportMissing(diagnostics_);
  EXPECT_EQ(onlyLine(), std::string("world.sdf:12:5: warning: 3 plugins were not found: they are left out: "
                                    "'libMyVeryOwnPlugin.so' (line 12), 'libFleetReferee.so' (line 12), "
                                    "'libUnderseaCurrents.so' (line 12)\n  hint: looked in ") +
                            PONGSIM_TEST_PLUGINS + "; PONGSIM_PLUGIN_PATH adds folders");
}

TEST_F(LoaderTest, FailsWithoutWhatTheUserAskedFor) {
  EXPECT_EQ(loader_.load(plugin("libMyVeryOwnPlugin.so"), Loader::Paths::kNeedLeave, kRequired, diagnostics_), nullptr);
  EXPECT_NE(onlyLine().find("error: plugin 'libMyVeryOwnPlugin.so' was not found\n"), std::string::npos);
}

TEST_F(LoaderTest, IsSilentAboutTheDefaultOfSdfWithoutAPlugin) {
  EXPECT_EQ(loader_.load(plugin("__default__", "__default__"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
            nullptr);
  loader_.reportMissing(diagnostics_);
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(LoaderTest, WarnsOnceOfASystemOfFortressThatIsNotThere) {
  EXPECT_EQ(loader_.load(plugin("ignition-gazebo-buoyancy-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
            nullptr);
  EXPECT_EQ(loader_.load(plugin("gz-sim-buoyancy-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
            nullptr);
  EXPECT_FALSE(diagnostics_.hasErrors());
  EXPECT_EQ(
      onlyLine(),
      "world.sdf:12:5: warning: plugin 'ignition-gazebo-buoyancy-system' is a system of Gazebo that is not supported "
      "yet: it is left out");
}

TEST_F(LoaderTest, KnowsTheSystemsOfLaterReleases) {
  EXPECT_EQ(loader_.load(plugin("gz-sim-lens-flare-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
            nullptr);
  EXPECT_EQ(
      onlyLine(),
      "world.sdf:12:5: warning: plugin 'gz-sim-lens-flare-system' is a system of Gazebo that is not supported yet: "
      "it is left out");
}

TEST_F(LoaderTest, SumsUpPluginsOfGazeboClassicAndRos) {
  for (const char* filename : {"libgazebo_ros_control.so", "libgazebo_ros_control.so", "libgazebo_imu_plugin.so",
                               "ign_ros_control-system", "libign_ros_control-system.so"}) {
    EXPECT_EQ(loader_.load(plugin(filename), Loader::Paths::kNeedLeave, kOptional, diagnostics_), nullptr);
  }
  loader_.reportMissing(diagnostics_);
  EXPECT_EQ(onlyLine(),
            "world.sdf:12:5: warning: 3 plugins are of Gazebo Classic or ROS: they are left out: "
            "'libgazebo_ros_control.so' (line 12), 'libgazebo_imu_plugin.so' (line 12), 'ign_ros_control-system' (line "
            "12)\n  hint: Fortress can't load them either");
}

TEST_F(LoaderTest, NamesThePackageThatHasAPlugin) {
  for (const char* filename : {"libgz_ros2_control-system.so", "gz_ros2_control-system", "pongsim-ros2-system",
                               "ignition-gazebo-log-system", "gz-sim-camera-video-recorder-system"}) {
    EXPECT_EQ(loader_.load(plugin(filename), Loader::Paths::kNeedLeave, kOptional, diagnostics_), nullptr);
  }
  const std::vector<Diagnostic>& all = diagnostics_.all();
  ASSERT_EQ(all.size(), 4U);
  const std::string ending = "\n  hint: the package pongsim-ros2 has it: apt-get install pongsim-ros2";
  EXPECT_EQ(format(all[0]),
            "world.sdf:12:5: warning: plugin 'libgz_ros2_control-system.so' is not installed: it is "
            "left out" +
                ending);
  EXPECT_EQ(format(all[1]),
            "world.sdf:12:5: warning: plugin 'pongsim-ros2-system' is not installed: it is left out" + ending);
  EXPECT_EQ(format(all[2]),
            "world.sdf:12:5: warning: plugin 'ignition-gazebo-log-system' is not installed: it is left out\n"
            "  hint: the package pongsim-log has it: apt-get install pongsim-log");
  EXPECT_NE(format(all[3]).find("\n  hint: the package pongsim-video has it: apt-get install pongsim-video"),
            std::string::npos);
}

TEST_F(LoaderTest, SaysWhyALibraryCannotBeUsed) {
  EXPECT_EQ(loader_.load(plugin("pongsim-ancient-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics_),
            nullptr);
  EXPECT_NE(onlyLine().find("world.sdf:12:5: warning: plugin 'pongsim-ancient-system' can't be loaded from "),
            std::string::npos);
}

TEST(LoaderSearchPath, TakesTheFirstFolderThatHasTheLibrary) {
  const test::TempFolder folder;
  folder.write("libpongsim-counting-system.so", "not a library");
  Diagnostics diagnostics;
  Loader good({PONGSIM_TEST_PLUGINS, folder.path()});
  EXPECT_NE(good.load(plugin("pongsim-counting-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics), nullptr);
  Loader bad({folder.path(), PONGSIM_TEST_PLUGINS});
  EXPECT_EQ(bad.load(plugin("pongsim-counting-system"), Loader::Paths::kNeedLeave, kOptional, diagnostics), nullptr);
}

TEST(LoaderSearchPath, BeginsWithTheFoldersOfTheEnvironment) {
  setenv("PONGSIM_PLUGIN_PATH", "/first:/second", 1);
  setenv("IGN_GAZEBO_SYSTEM_PLUGIN_PATH", ":/third:", 1);
  setenv("GZ_SIM_SYSTEM_PLUGIN_PATH", "/fourth", 1);
  const std::vector<std::filesystem::path> folders = defaultSearchPath();
  ASSERT_GE(folders.size(), 4U);
  EXPECT_EQ(folders[0], "/first");
  EXPECT_EQ(folders[1], "/second");
  EXPECT_EQ(folders[2], "/third");
  EXPECT_EQ(folders[3], "/fourth");
}

}  // namespace
}  // namespace pongsim::plugin
