#include "msgs/scene/scene_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/scene.pb.h>

#include "support/msgs/scene_support.hh"

namespace pongsim::msgs {
namespace {

class SceneMessageTest : public testing::Test {
 protected:
  const description::World world_ = test::cartWorld();
  const world::Entities entities_{world_};
  world::State state_{entities_};
  ignition::msgs::Scene scene_;
};

TEST_F(SceneMessageTest, TellsOfModelsLinksAndAllThatIsInThem) {
  setScene(entities_, state_, scene_);
  ASSERT_EQ(scene_.model_size(), 2);
  const ignition::msgs::Model& cart = scene_.model(1);
  EXPECT_EQ(cart.name(), "cart");
  EXPECT_EQ(cart.pose().position().x(), 1);
  ASSERT_EQ(cart.link_size(), 1);
  const ignition::msgs::Link& base = cart.link(0);
  EXPECT_EQ(base.pose().position().z(), 2);
  ASSERT_EQ(base.visual_size(), 1);
  EXPECT_EQ(base.visual(0).name(), "look");
  EXPECT_EQ(base.visual(0).id(), base.id() + 1);
  EXPECT_EQ(base.visual(0).parent_id(), base.id());
  EXPECT_EQ(base.visual(0).geometry().sphere().radius(), 0.5);
  EXPECT_EQ(base.visual(0).material().diffuse().r(), 0.5F);
  ASSERT_EQ(base.light_size(), 1);
  EXPECT_EQ(base.light(0).parent_id(), base.id());
  ASSERT_EQ(base.sensor_size(), 1);
  EXPECT_EQ(base.sensor(0).name(), "gyro");
  ASSERT_EQ(cart.model_size(), 1);
  EXPECT_EQ(cart.model(0).pose().position().z(), 3);
  ASSERT_EQ(scene_.light_size(), 1);
  EXPECT_EQ(scene_.light(0).name(), "sun");
  EXPECT_EQ(scene_.light(0).parent_id(), 1U);
}

TEST_F(SceneMessageTest, TellsWhereThingsAreNow) {
  state_.links[entities_.findLink("cart::base")].X_WorldLink.position += Vector3(0, 7, 0);
  setScene(entities_, state_, scene_);
  EXPECT_EQ(scene_.model(1).pose().position().y(), 7);
  EXPECT_EQ(scene_.model(1).link(0).pose().position().y(), 0);
  EXPECT_EQ(scene_.model(1).model(0).pose().position().y(), -7);
}

TEST_F(SceneMessageTest, TellsOfThoseThatAreWantedOnly) {
  const std::uint64_t sun = entities_.lights()[entities_.findLight(world::kNoSlot, "sun")].id.value;
  setScene(entities_, state_, scene_, [sun](std::uint64_t id) { return id == sun; });
  EXPECT_EQ(scene_.model_size(), 0);
  EXPECT_EQ(scene_.light_size(), 1);
}

TEST_F(SceneMessageTest, DrawsWhoHoldsWhom) {
  EXPECT_EQ(
      sceneGraph(entities_),
      "digraph {\n"
      "  1 [label=\"w (1)\"];\n  2 [label=\"ground (2)\"];\n  3 [label=\"l (3)\"];\n  4 [label=\"cart (4)\"];\n"
      "  5 [label=\"base (5)\"];\n  6 [label=\"look (6)\"];\n  8 [label=\"lamp (8)\"];\n  9 [label=\"gyro (9)\"];\n"
      "  10 [label=\"arm (10)\"];\n  11 [label=\"tip (11)\"];\n  13 [label=\"sun (13)\"];\n"
      "  1 -> 2 [label=1];\n  1 -> 4 [label=1];\n  4 -> 10 [label=1];\n  2 -> 3 [label=1];\n  4 -> 5 [label=1];\n"
      "  10 -> 11 [label=1];\n  5 -> 6 [label=1];\n  5 -> 8 [label=1];\n  1 -> 13 [label=1];\n"
      "  5 -> 9 [label=1];\n}\n");
}

}  // namespace
}  // namespace pongsim::msgs
