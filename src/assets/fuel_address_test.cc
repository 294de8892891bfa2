#include "pongsim/files/fuel_address.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim {
namespace {

TEST(FuelAddress, NamesServerOwnerModelAndVersion) {
  const auto address = parseFuelAddress("https://Fuel.GazeboSim.org/1.0/OpenRobotics/models/Coke Can/12");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->scheme, "https");
  EXPECT_EQ(address->host, "fuel.gazebosim.org");
  EXPECT_EQ(address->apiVersion, "1.0");
  EXPECT_EQ(address->owner, "OpenRobotics");
  EXPECT_EQ(address->name, "Coke Can");
  EXPECT_FALSE(address->isWorld);
  EXPECT_EQ(address->version, 12);
  EXPECT_EQ(address->file, "");
  EXPECT_EQ(address->url(), "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke%20Can");
}

TEST(FuelAddress, IsThatOfAnyServerWithOrWithoutTheVersionOfItsInterface) {
  for (const char* uri : {"http://localhost:8000/o/models/m", "http://localhost:8000/1.0/o/models/m/"}) {
    const auto address = parseFuelAddress(uri);
    ASSERT_TRUE(address) << uri;
    EXPECT_EQ(address->host, "localhost:8000");
    EXPECT_EQ(address->url(), "http://localhost:8000/1.0/o/models/m");
  }
}

TEST(FuelAddress, NamesAWorld) {
  const auto address = parseFuelAddress("https://fuel.gazebosim.org/1.0/o/worlds/w/3");
  ASSERT_TRUE(address);
  EXPECT_TRUE(address->isWorld);
  EXPECT_EQ(address->url(), "https://fuel.gazebosim.org/1.0/o/worlds/w");
  EXPECT_EQ(fuelFolder(*address, "/c"), "/c/fuel.gazebosim.org/o/worlds/w");
}

TEST(FuelAddress, LeavesTheVersionToTheCache) {
  for (const char* ending : {"", "/", "/tip"}) {
    const auto address =
        parseFuelAddress(std::string("https://fuel.ignitionrobotics.org/1.0/o/models/Coke%20Can") + ending);
    ASSERT_TRUE(address) << ending;
    EXPECT_EQ(address->name, "Coke Can");
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
       {"", "/1.0", "/1.0/o", "/1.0/o/models", "/1.0/o/collections/c", "/1.0/o/models/m/zero", "/1.0/o/models/m/0",
        "/1.0/o/models/m/-1", "/1.0//models/m", "/1.0/../models/m", "/1.0/o/models/%2e%2E", "/1.0/o/models/a%2fb",
        "/1.0/o/models/m/1/x", "/1.0/o/models/m/99999999999999999999", "/1.0/o/models/m/1/files/../../../x"}) {
    const std::string uri = std::string("https://fuel.gazebosim.org") + ending;
    EXPECT_TRUE(isFuelAddress(uri)) << uri;
    EXPECT_FALSE(parseFuelAddress(uri)) << uri;
  }
  for (const char* uri : {"https://../1.0/o/models/m", "https:///1.0/o/models/m", "https://a b/1.0/o/models/m"}) {
    EXPECT_FALSE(parseFuelAddress(uri)) << uri;
  }
  EXPECT_FALSE(isFuelAddress("model://fuel.gazebosim.org"));
}

TEST(FuelAddress, HasAFolderInLowerCase) {
  const auto address = parseFuelAddress("https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke Can");
  ASSERT_TRUE(address);
  EXPECT_EQ(fuelFolder(*address, "/c"), "/c/fuel.gazebosim.org/openrobotics/models/coke can");
}

TEST(FuelCache, HasTheHighestVersionByNumberThatIsWhole) {
  const test::TempFolder folder;
  const std::filesystem::path model = folder.path() / "m";
  folder.write("m/9/model.sdf", "");
  folder.write("m/10/model.sdf", "");
  folder.write("m/11", "not a folder");
  folder.write("m/12a/model.sdf", "");
  EXPECT_EQ(newestFuelVersion(model), 10);
  EXPECT_FALSE(newestFuelVersion(model / "9"));
  EXPECT_FALSE(newestFuelVersion(model / "nowhere"));
  // Fortress is unpacking it
  folder.write("m/10/m.zip", "");
  EXPECT_FALSE(isWholeFuelVersion(model / "10"));
  EXPECT_EQ(newestFuelVersion(model), 9);
}

}  // namespace
}  // namespace pongsim
