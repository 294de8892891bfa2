#include "assets/places.hh"

#include <gtest/gtest.h>

#include <list>
#include <string>
#include <vector>

#include "support/environment_variable.hh"

namespace pongsim::assets {
namespace {

/// Starts without these environment variables, and restores them.
class PlacesTest : public testing::Test {
 protected:
  PlacesTest() {
    for (const char* name : {"PONGSIM_RESOURCE_PATH", "SDF_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH",
                             "IGN_FILE_PATH", "IGN_FUEL_CACHE_PATH", "HOME"}) {
      variables_.emplace_back(name).unset();
    }
  }

 private:
  std::list<pongsim::test::EnvironmentVariable> variables_;
};

using Folders = std::vector<std::filesystem::path>;

TEST_F(PlacesTest, AreNowhereWithoutVariables) {
  EXPECT_EQ(Places::fromEnvironment().folders, Folders());
  EXPECT_EQ(Places::fromEnvironment().fuelCache, "");
}

TEST_F(PlacesTest, ComeInTheOrderOfTheVariables) {
  setenv("IGN_FILE_PATH", "/f", 1);
  setenv("GZ_SIM_RESOURCE_PATH", "/e", 1);
  setenv("IGN_GAZEBO_RESOURCE_PATH", ":/c::/d:", 1);
  setenv("SDF_PATH", "/b", 1);
  setenv("PONGSIM_RESOURCE_PATH", "/a", 1);
  EXPECT_EQ(Places::fromEnvironment().folders, (Folders{"/a", "/b", "/c", "/d", "/e", "/f"}));
}

TEST_F(PlacesTest, HaveTheFuelCacheBelowHomeOrWhereItIsSaidToBe) {
  setenv("HOME", "/home/u", 1);
  EXPECT_EQ(Places::fromEnvironment().fuelCache, "/home/u/.ignition/fuel");
  setenv("IGN_FUEL_CACHE_PATH", "/cache", 1);
  EXPECT_EQ(Places::fromEnvironment().fuelCache, "/cache");
}

}  // namespace
}  // namespace pongsim::assets
