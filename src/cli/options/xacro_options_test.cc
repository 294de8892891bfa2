#include "cli/options/xacro_options.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <cstdlib>
#include <fstream>

#include "shared/program/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

TEST(XacroOptions, KnowArguments) {
  EXPECT_TRUE(isXacroArgument("wheels:=4"));
  EXPECT_TRUE(isXacroArgument("use_sim-time:="));
  EXPECT_FALSE(isXacroArgument(":=4"));
  EXPECT_FALSE(isXacroArgument("/a/b:=4"));
  EXPECT_FALSE(isXacroArgument("robot.sdf"));
}

TEST(XacroOptions, PassArguments) {
  passToXacro({"a:=1", "b:=x y"});
  EXPECT_STREQ(std::getenv("PONGSIM_XACRO_ARGUMENTS"), "a:=1\nb:=x y\n");
  EXPECT_THROW(passToXacro({"a=1"}), UsageError);
  unsetenv("PONGSIM_XACRO_ARGUMENTS");
}

TEST(XacroOptions, FindPackages) {
  const test::TempFolder folder;
  const std::filesystem::path package = folder.path() / "src/robots/arm";
  std::filesystem::create_directories(package / "models");
  std::ofstream(package / "package.xml") << "<package><name>\n robot_arm\n</name></package>";
  setenv("PONGSIM_RESOURCE_PATH", "/before", 1);
  CLI::App app;
  addPackagesOption(app);
  app.parse("--packages " + folder.path().string());
  const std::string found = std::filesystem::canonical(package).string();
  EXPECT_EQ(std::getenv("PONGSIM_RESOURCE_PATH"),
            "/before:" + std::filesystem::path(found).parent_path().string() + ":" + found + "/models");
  EXPECT_THROW(app.parse("--packages " + (package / "models").string()), UsageError);
  unsetenv("PONGSIM_RESOURCE_PATH");
}

}  // namespace
}  // namespace pongsim::cli
