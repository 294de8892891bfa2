#include "cli/world_file.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

class WorldFile : public testing::Test {
 protected:
  void SetUp() override { leaveVariablesUnset(); }
  void TearDown() override { leaveVariablesUnset(); }

  static void leaveVariablesUnset() {
    for (const char* name : {"PONGSIM_RESOURCE_PATH", "SDF_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH"}) {
      unsetenv(name);
    }
  }

  test::TempFolder first_, second_;
};

TEST_F(WorldFile, IsTakenAsGivenWhereItIsThere) {
  const std::filesystem::path file = first_.write("here.sdf", "");
  EXPECT_EQ(findWorldFile(file.string()), file);
}

TEST_F(WorldFile, IsLookedForInTheResourcePathsInTheirOrder) {
  second_.write("a.sdf", "");
  const std::filesystem::path inSecond = second_.write("sub/b.sdf", "");
  const std::filesystem::path inFirst = first_.write("a.sdf", "");
  setenv("IGN_GAZEBO_RESOURCE_PATH", (":" + first_.path().string() + "::/nowhere").c_str(), 1);
  setenv("GZ_SIM_RESOURCE_PATH", second_.path().c_str(), 1);
  EXPECT_EQ(findWorldFile("a.sdf"), inFirst);
  EXPECT_EQ(findWorldFile("sub/b.sdf"), inSecond);
}

TEST_F(WorldFile, KeepsItsNameWhereItIsNowhere) {
  setenv("IGN_GAZEBO_RESOURCE_PATH", first_.path().c_str(), 1);
  for (const char* name : {"missing.sdf", "", "/nowhere/at/all.sdf"}) EXPECT_EQ(findWorldFile(name), name);
}

}  // namespace
}  // namespace pongsim::cli
