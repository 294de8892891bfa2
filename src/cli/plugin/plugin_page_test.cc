#include "cli/plugin/plugin_page.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

namespace pongsim::cli {
namespace {

const plugin::Inspection& diffDrive() {
  static const auto looked =
      plugin::Inspection::of(std::filesystem::path(PONGSIM_OWN_PLUGINS) / "libpongsim-diff-drive-system.so");
  return std::get<plugin::Inspection>(looked);
}

TEST(PluginPage, TellsATerminalOfClassesParametersAndTopics) {
  const std::string text = pluginText(diffDrive());
  for (const char* part : {"plugin interface version ", "class ignition::gazebo::systems::DiffDrive, also gz::sim::",
                           "Belongs in a <model>.", "<left_joint>", "required, repeated", "number [m]", "publishes",
                           "<odom_topic>", "ignition.msgs.Odometry"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(PluginPage, IsATableInMarkdown) {
  const std::string text = pluginMarkdown(diffDrive());
  EXPECT_TRUE(text.starts_with("## DiffDrive\n")) << text;
  for (const char* part :
       {"filename `ignition-gazebo-diff-drive-system`, class `ignition::gazebo::systems::DiffDrive`; belongs in a "
        "\\<model>\n",
        "| `<wheel_radius>` | number [m] | 0.2 | radius of the wheels |\n",
        "| subscribes to | `/model/M/enable` | ignition.msgs.Boolean |"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(PluginPage, ShowsAFamilyOfParametersOnce) {
  const auto looked =
      plugin::Inspection::of(std::filesystem::path(PONGSIM_OWN_PLUGINS) / "libpongsim-hydrodynamics-system.so");
  const std::string text = pluginMarkdown(std::get<plugin::Inspection>(looked));
  const std::string row = "| `<{xyzkmn}{UVWPQR}>` | number | 0 |";
  EXPECT_NE(text.find(row), std::string::npos) << text;
  EXPECT_EQ(text.find(row), text.rfind(row));
  EXPECT_EQ(text.find("`<xU>`"), std::string::npos);
}

TEST(PluginPage, TellsOfWhatIsPartOfPongsimItself) {
  const plugin::CoreSystem& system = *plugin::coreSystem("libignition-gazebo-user-commands-system.so");
  EXPECT_TRUE(
      pluginText(system).starts_with("part of pongsim itself\n\nclass ignition::gazebo::systems::UserCommands\n"));
  const std::string markdown = pluginMarkdown(system);
  EXPECT_TRUE(markdown.starts_with("## UserCommands\n")) << markdown;
  EXPECT_NE(markdown.find("| offers | `/world/W/set_pose` | ignition.msgs.Pose, ignition.msgs.Boolean |"),
            std::string::npos)
      << markdown;
}

TEST(PluginPage, TellsInWhatSystemsBelongThatGiveItData) {
  const plugin::CoreSystem& system = *plugin::coreSystem("thermal");
  EXPECT_NE(pluginText(system).find("Belongs in a <visual>.\n"), std::string::npos) << pluginText(system);
  const std::string markdown = pluginMarkdown(system);
  EXPECT_NE(markdown.find("belongs in a \\<visual>\n"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("| `<temperature>` | element |  | the same everywhere [K] |"), std::string::npos) << markdown;
}

}  // namespace
}  // namespace pongsim::cli
