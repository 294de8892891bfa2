#include "ros2/config/distro.hh"

#include <gtest/gtest.h>

#include "support/environment_variable.hh"

namespace pongsim::ros2 {
namespace {

TEST(DistroTest, ShipsTheOlderInterfacesUpToKilted) {
  for (const char* name : {"", "humble", "jazzy", "kilted", "nobody"}) EXPECT_TRUE(shipsOlderInterfaces(name)) << name;
  for (const char* name : {"lyrical", "rolling"}) EXPECT_FALSE(shipsOlderInterfaces(name)) << name;
}

TEST(DistroTest, IsThatOfTheEnvironment) {
  const test::EnvironmentVariable distro("ROS_DISTRO", "kilted");
  EXPECT_EQ(distroOfEnvironment(), "kilted");
}

}  // namespace
}  // namespace pongsim::ros2
