#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <vector>

#include "sdf/loader.hh"
#include "sim/api/access.hh"
#include "sim/edits/editor.hh"
#include "support/sim/level_world.hh"

namespace {

long allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

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
    const long before = allocations;
    for (int i = 0; i < 100; ++i) {
      access.levels.update();
      access.levels.listPerformers(performers);
    }
    EXPECT_EQ(allocations, before) << y;
  }
  EXPECT_GT(allocations, 0);
}

}  // namespace
}  // namespace pongsim::sim
