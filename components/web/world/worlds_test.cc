#include "web/world/worlds.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>

#include "support/web/stepped_world.hh"

namespace pongsim::web {
namespace {

namespace im = ignition::msgs;

TEST(Worlds, HaveATopicOfSeveralOnceAndWhereItIsPublished) {
  const auto worlds = std::make_shared<Worlds>();
  SteppedWorld first(worlds, "a");
  SteppedWorld second(worlds, "b");
  const auto watch = worlds->watch({.changed = [] {}});
  const Subscription listens = first.node().subscribe<im::Clock>("/clock", [](const auto&) {});
  const Publisher speaks = second.node().advertise<im::Clock>("/clock");
  const Publisher other = first.node().advertise<im::StringMsg>("/a");
  const auto count = [&] {
    return std::ranges::count_if(worlds->topics(), [](const auto& place) { return place.topic.name == "/clock"; });
  };
  ASSERT_TRUE(first.stepUntil([&] { return count() == 1; }));
  ASSERT_TRUE(second.stepUntil([&] { return worlds->topics().back().world->world() == "b"; }));
  EXPECT_EQ(count(), 1);
  EXPECT_EQ(worlds->topics().front().topic.name, "/a");
  EXPECT_EQ(worlds->findTopic("/clock")->world->world(), "b");
  EXPECT_EQ(worlds->findTopic("/a")->topic.type, "ignition.msgs.StringMsg");
  EXPECT_FALSE(worlds->findTopic("/b").has_value());
  EXPECT_FALSE(worlds->findService("/a").has_value());
}

TEST(Worlds, AreFoundByNameAndGoWhenTheyEnd) {
  const auto worlds = std::make_shared<Worlds>();
  int changes = 0;
  const auto watch = worlds->watch({.changed = [&] { ++changes; }});
  SteppedWorld world(worlds, "a");
  EXPECT_EQ(changes, 1);
  EXPECT_NE(worlds->find("a"), nullptr);
  EXPECT_EQ(worlds->find("b"), nullptr);
  world.end();
  EXPECT_EQ(changes, 2);
  EXPECT_EQ(worlds->find("a"), nullptr);
}

}  // namespace
}  // namespace pongsim::web
