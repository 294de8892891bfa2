#include "ros2/services/service_names.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

TEST(ServiceNames, AreTheNodesOwnOrHaveThePrefix) {
  EXPECT_EQ(ServiceNames("~", "w").ofSimulator("spawn_entity"), "~/spawn_entity");
  EXPECT_EQ(ServiceNames("/gzserver", "w").ofSimulator("spawn_entity"), "/gzserver/spawn_entity");
  EXPECT_EQ(ServiceNames("/", "w").ofSimulator("spawn_entity"), "/spawn_entity");
}

TEST(ServiceNames, OfAWorldAreThoseOfTheSimulationAsRosAllowsThem) {
  const ServiceNames names("~", "my world-2");
  EXPECT_EQ(names.inSimulation("control"), "/world/my_world-2/control");
  EXPECT_EQ(names.ofWorld("control"), "world/my_world_2/control");
}

}  // namespace
}  // namespace pongsim::ros2
