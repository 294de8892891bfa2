#include "web/typed/asset_address.hh"

#include <gtest/gtest.h>

namespace pongsim::web::typed {
namespace {

TEST(AssetAddress, GoesThereAndBack) {
  EXPECT_EQ(packageAddress("/home/me/my arm.dae"), "package://pongsim/file/home/me/my%20arm.dae");
  EXPECT_EQ(packageAddress("model://arm/meshes/a.dae"), "package://pongsim/model/arm/meshes/a.dae");
  EXPECT_EQ(packageAddress("https://fuel.example.org/1.0/a#b?c"),
            "package://pongsim/https/fuel.example.org/1.0/a%23b%3Fc");
  for (const char* address : {"/home/me/my arm.dae", "model://arm/meshes/a.dae", "https://x/1.0/a#b?c", "/a%20b"}) {
    EXPECT_EQ(sceneAddress(packageAddress(address)), address);
  }
  EXPECT_EQ(sceneAddress(packageAddress("file:///home/a.dae")), "/home/a.dae");
}

TEST(AssetAddress, LeavesOthersAsTheyAre) {
  for (const char* address : {"", "model://a", "package://other/a", "package://pongsim/", "package://pongsim/x"}) {
    EXPECT_EQ(sceneAddress(address), address);
  }
  EXPECT_EQ(sceneAddress("package://pongsim/file/100%"), "/100%");
  EXPECT_EQ(sceneAddress("package://pongsim/file/%zz"), "/%zz");
}

}  // namespace
}  // namespace pongsim::web::typed
