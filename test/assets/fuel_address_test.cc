#include "assets/fuel_address.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

TEST(FuelAddress, NamesServerOwnerModelAndVersion) {
  const auto address = parseFuelAddress("https://Fuel.GazeboSim.org/1.0/OpenRobotics/models/Coke Can/12");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "fuel.gazebosim.org");
  EXPECT_EQ(address->owner, "OpenRobotics");
  EXPECT_EQ(address->model, "Coke Can");
  EXPECT_EQ(address->version, 12);
  EXPECT_EQ(address->file, "");
}

TEST(FuelAddress, LeavesTheVersionToTheCache) {
  for (const char* ending : {"", "/", "/tip"}) {
    const auto address =
        parseFuelAddress(std::string("https://fuel.ignitionrobotics.org/1.0/o/models/Coke%20Can") + ending);
    ASSERT_TRUE(address) << ending;
    EXPECT_EQ(address->model, "Coke Can");
    EXPECT_FALSE(address->version);
  }
}

TEST(FuelAddress, NamesAFileOfTheModel) {
  const auto address = parseFuelAddress("https://fuel.gazebosim.org/1.0/o/models/m/2/files/meshes/a.dae");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->version, 2);
  EXPECT_EQ(address->file, "meshes/a.dae");
}

TEST(FuelAddress, IsNoneWhereAPartIsMissingOrOdd) {
  for (const char* ending :
       {"", "/1.0", "/1.0/o", "/1.0/o/models", "/1.0/o/worlds/w", "/2.0/o/models/m", "/1.0/o/models/m/zero",
        "/1.0/o/models/m/0", "/1.0/o/models/m/-1", "/1.0//models/m", "/1.0/../models/m", "/1.0/o/models/%2e%2E",
        "/1.0/o/models/a%2fb", "/1.0/o/models/m/1/x", "/1.0/o/models/m/99999999999999999999"}) {
    const std::string uri = std::string("https://fuel.gazebosim.org") + ending;
    EXPECT_TRUE(isFuelAddress(uri)) << uri;
    EXPECT_FALSE(parseFuelAddress(uri)) << uri;
  }
  EXPECT_FALSE(isFuelAddress("https://example.org/1.0/o/models/m"));
  EXPECT_FALSE(isFuelAddress("model://fuel.gazebosim.org"));
}

TEST(FuelAddress, HasAFolderInLowerCase) {
  const auto address = parseFuelAddress("https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke Can");
  ASSERT_TRUE(address);
  EXPECT_EQ(cacheFolder(*address, "h", "/c"), "/c/h/openrobotics/models/coke can");
}

TEST(FuelAddress, TakesTheHighestVersionByNumber) {
  const test::TempFolder folder;
  folder.write("9/model.sdf", "");
  folder.write("10/model.sdf", "");
  folder.write("11", "not a folder");
  folder.write("12a/model.sdf", "");
  EXPECT_EQ(newestVersion(folder.path()), folder.path() / "10");
  EXPECT_FALSE(newestVersion(folder.path() / "9"));
  EXPECT_FALSE(newestVersion(folder.path() / "nowhere"));
}

}  // namespace
}  // namespace pongsim::assets
