#include "web/typed/world_scene.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/uint32_v.pb.h>

#include "support/web/stepped_world.hh"

namespace pongsim::web::typed {
namespace {

namespace im = ignition::msgs;

TEST(WorldScene, IsAskedForAgainWhenSomethingHasComeOrGone) {
  const auto worlds = std::make_shared<Worlds>();
  SteppedWorld world(worlds);
  int asked = 0;
  Service service = world.node().serve<im::Empty, im::Scene>("/world/w/scene/info", [&](const auto&, im::Scene& scene) {
    scene.set_name(std::to_string(++asked));
    return true;
  });
  auto come = world.node().advertise<im::Scene>("/world/w/scene/info");
  auto gone = world.node().advertise<im::UInt32_V>("/world/w/scene/deletion");
  auto scene = WorldScene::open(worlds->find("w"));
  EXPECT_EQ(scene->state(), nullptr);
  int told = 0;
  auto watch = scene->watch([&] { ++told; });
  ASSERT_TRUE(world.stepUntil([&] { return scene->state() != nullptr; }));
  EXPECT_EQ(scene->state()->scene.name(), "1");
  gone.publish(im::UInt32_V());
  come.publish(im::Scene());
  ASSERT_TRUE(world.stepUntil([&] { return scene->state()->scene.name() == "3"; }));
  EXPECT_EQ(told, 3);
  watch.reset();
  scene.reset();
  world.step();
  EXPECT_FALSE(come.hasSubscribers());
  EXPECT_FALSE(gone.hasSubscribers());
}

TEST(WorldScene, StaysEmptyWhereTheWorldDoesNotTellIt) {
  const auto worlds = std::make_shared<Worlds>();
  SteppedWorld world(worlds);
  const auto scene = WorldScene::open(worlds->find("w"));
  world.steps(3);
  EXPECT_EQ(scene->state(), nullptr);
}

}  // namespace
}  // namespace pongsim::web::typed
