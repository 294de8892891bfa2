#include "plugin/core_systems.hh"

#include <gtest/gtest.h>

#include "plugin/fortress_systems.hh"

namespace pongsim::plugin {
namespace {

TEST(CoreSystems, AreSomeOfGazebo) {
  ASSERT_FALSE(coreSystems().empty());
  for (const CoreSystem& system : coreSystems()) {
    EXPECT_TRUE(isOfGazebo(system.name)) << system.name;
    EXPECT_FALSE(system.declaration.text().empty()) << system.name;
  }
}

TEST(CoreSystems, AreFoundByAllNamesThatWorldsUse) {
  ASSERT_NE(coreSystem("gz-sim-physics-system"), nullptr);
  EXPECT_EQ(coreSystem("gz-sim-physics-system")->className, "ignition::gazebo::systems::Physics");
  EXPECT_EQ(coreSystem("physics"), coreSystem("libignition-gazebo-physics-system.so"));
  EXPECT_EQ(coreSystem("diff-drive"), nullptr);
}

}  // namespace
}  // namespace pongsim::plugin
