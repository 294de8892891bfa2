// entity_services_test.cc tests spawning itself, which needs a running simulation.
#include "ros2/services/spawner.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

TEST(EntityNames, AreWhatSdfAllows) {
  for (const char* good : {"", "box", "box 1", "größe", "a/b", "a:b", "__a"})
    EXPECT_EQ(entityNameError(good), std::nullopt);
  EXPECT_EQ(entityNameError("a::b"), "contains '::', which separates names");
  EXPECT_EQ(entityNameError("world"), "is the world's frame");
  EXPECT_EQ(entityNameError("__root__"), "is reserved by SDF");
  EXPECT_EQ(entityNameError("a\tb"), "has a control character");
  EXPECT_EQ(entityNameError(std::string(1001, 'a')), "is longer than 1000 bytes");
}

TEST(EntityNamespaces, AreThoseOfRos) {
  for (const char* good : {"robot1", "/robot1", "/fleet/robot_1"}) EXPECT_EQ(nameSpaceError(good), std::nullopt);
  for (const char* bad : {"/", "1robot", "a b", "a//b", "a-b", "a/", "~/a", "é"}) {
    EXPECT_TRUE(nameSpaceError(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace pongsim::ros2
