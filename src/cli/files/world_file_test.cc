#include "cli/files/world_file.hh"

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

TEST_F(WorldFile, IsInTheCacheWhereItsAddressIsThatOfAFuelServer) {
  setenv("PONGSIM_OFFLINE", "1", 1);
  setenv("IGN_FUEL_CACHE_PATH", first_.path().c_str(), 1);
  const std::filesystem::path folder = first_.path() / "fuel.gazebosim.org/o";
  const std::string server = "https://fuel.gazebosim.org/1.0/o/";
  first_.write("fuel.gazebosim.org/o/worlds/w/2/b.sdf", "");
  first_.write("fuel.gazebosim.org/o/worlds/w/2/c.sdf", "");
  first_.write("fuel.gazebosim.org/o/worlds/e/1/readme.txt", "");
  first_.write("fuel.gazebosim.org/o/models/m/1/model.config", "<model><sdf version='1.9'>m.sdf</sdf></model>");
  first_.write("fuel.gazebosim.org/o/models/m/1/m.sdf", "");
  Diagnostics diagnostics;
  EXPECT_EQ(fetchWorldFile(server + "worlds/w", diagnostics), folder / "worlds/w/2/b.sdf");
  first_.write("fuel.gazebosim.org/o/worlds/w/2/metadata.pbtxt",
               "name: \"w\"\nworld {\n  file_format { name: \"sdf\" }\n  file: \"c.sdf\"\n}\n");
  EXPECT_EQ(fetchWorldFile(server + "worlds/w", diagnostics), folder / "worlds/w/2/c.sdf");
  // what is not known, or broken after it, does no harm
  first_.write("fuel.gazebosim.org/o/worlds/w/2/metadata.pbtxt", "new: 3 world { file: \"c.sdf\" } name: {{");
  EXPECT_EQ(fetchWorldFile(server + "worlds/w", diagnostics), folder / "worlds/w/2/c.sdf");
  // one that is not the world's does not count
  first_.write("fuel.gazebosim.org/o/worlds/w/2/metadata.pbtxt", "name: \"world\" model { file: \"c.sdf\" }");
  EXPECT_EQ(fetchWorldFile(server + "worlds/w", diagnostics), folder / "worlds/w/2/b.sdf");
  // neither does one that leads elsewhere
  first_.write("fuel.gazebosim.org/o/worlds/w/2/metadata.pbtxt", "world { file: \"../../../../x.sdf\" }");
  EXPECT_EQ(fetchWorldFile(server + "worlds/w/2", diagnostics), folder / "worlds/w/2/b.sdf");
  EXPECT_EQ(fetchWorldFile(server + "models/m", diagnostics), folder / "models/m/1/m.sdf");
  EXPECT_EQ(fetchWorldFile("here.sdf", diagnostics), "here.sdf");
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_FALSE(fetchWorldFile(server + "worlds/e", diagnostics));
  EXPECT_FALSE(fetchWorldFile(server + "worlds/none", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 2U);
  EXPECT_TRUE(diagnostics.all()[0].message.starts_with("there is no SDF file in '"));
  EXPECT_EQ(diagnostics.all()[1].message, "'" + server + "worlds/none' is not in the local Fuel cache");
  unsetenv("IGN_FUEL_CACHE_PATH");
}

}  // namespace
}  // namespace pongsim::cli
