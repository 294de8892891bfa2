#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "sdf/loader.hh"
#include "sim/api/access.hh"
#include "sim/edits/editor.hh"
#include "support/counted_allocations.hh"
#include "support/sim/level_world.hh"

namespace pongsim::sim {
namespace {

TEST(LevelsAllocation, AllocateNothingWhereNothingChanges) {
  Diagnostics diagnostics;
  const sdf::Root root = sdf::loadText(test::levelWorld(), "world.sdf", diagnostics, {});
  ASSERT_TRUE(diagnostics.all().empty());
  Access access(root.worlds.at(0));
  const world::Entities& entities = access.entities;
  access.levels.use();
  access.levels.start();
  access.levels.update();
  EXPECT_EQ(entities.listSetAside().size(), 5U);
  std::vector<Performer> performers;
  access.levels.listPerformers(performers);
  // moves within the levels' buffers, which loads and unloads nothing
  const auto put = [&](double x, double y) {
    Editor(access).setPose(entities.findModel("sphere"), {{x, y, 0}, Quaternion::Identity()}, AfterMove::kStop);
  };
  put(40, 0);
  access.levels.update();
  EXPECT_EQ(entities.listSetAside().size(), 4U);
  for (const double y : {0.0, -20.0, -10.0}) {
    put(40, y);
    const long before = test::allocations;
    for (int i = 0; i < 100; ++i) {
      access.levels.update();
      access.levels.listPerformers(performers);
    }
    EXPECT_EQ(test::allocations, before) << y;
  }
  EXPECT_GT(test::allocations, 0);
}

}  // namespace
}  // namespace pongsim::sim
