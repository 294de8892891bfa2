#include "assets/places.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "support/environment_variable.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

/// Starts without these environment variables, and restores them.
class PlacesTest : public testing::Test {
 protected:
  PlacesTest() {
    for (const char* name : {"PONGSIM_RESOURCE_PATH", "SDF_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH",
                             "IGN_FILE_PATH", "GZ_FILE_PATH", "IGN_FUEL_CACHE_PATH", "GZ_FUEL_CACHE_PATH", "HOME"}) {
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
  setenv("GZ_FILE_PATH", "/g", 1);
  setenv("IGN_FILE_PATH", "/f", 1);
  setenv("GZ_SIM_RESOURCE_PATH", "/e", 1);
  setenv("IGN_GAZEBO_RESOURCE_PATH", ":/c::/d:", 1);
  setenv("SDF_PATH", "/b", 1);
  setenv("PONGSIM_RESOURCE_PATH", "/a", 1);
  EXPECT_EQ(Places::fromEnvironment().folders, (Folders{"/a", "/b", "/c", "/d", "/e", "/f", "/g"}));
}

TEST_F(PlacesTest, HaveTheFuelCacheBelowHomeOrWhereItIsSaidToBe) {
  setenv("HOME", "/home/u", 1);
  EXPECT_EQ(Places::fromEnvironment().fuelCache, "/home/u/.ignition/fuel");
  setenv("GZ_FUEL_CACHE_PATH", "/later", 1);
  EXPECT_EQ(Places::fromEnvironment().fuelCache, "/later");
  setenv("IGN_FUEL_CACHE_PATH", "/cache", 1);
  EXPECT_EQ(Places::fromEnvironment().fuelCache, "/cache");
}

TEST_F(PlacesTest, HaveTheFuelCacheOfLaterReleasesIfFortressHasNone) {
  const pongsim::test::TempFolder home;
  setenv("HOME", home.path().c_str(), 1);
  std::filesystem::create_directories(home.path() / ".gz/fuel");
  EXPECT_EQ(Places::fromEnvironment().fuelCache, home.path() / ".gz/fuel");
  std::filesystem::create_directories(home.path() / ".ignition/fuel");
  EXPECT_EQ(Places::fromEnvironment().fuelCache, home.path() / ".ignition/fuel");
}

}  // namespace
}  // namespace pongsim::assets
