#include "assets/places.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace pongsim::assets {
namespace {

/// Sets environment variables for a test, and restores them.
class PlacesTest : public testing::Test {
 protected:
  PlacesTest() {
    for (const char* name : {"PONGSIM_RESOURCE_PATH", "SDF_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH",
                             "IGN_FILE_PATH", "IGN_FUEL_CACHE_PATH", "HOME"}) {
      const char* const value = std::getenv(name);
      before_.emplace_back(name, value != nullptr ? std::optional<std::string>(value) : std::nullopt);
      unsetenv(name);
    }
  }
  ~PlacesTest() override {
    for (const auto& [name, value] : before_) {
      value ? setenv(name, value->c_str(), 1) : unsetenv(name);
    }
  }

 private:
  std::vector<std::pair<const char*, std::optional<std::string>>> before_;
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
