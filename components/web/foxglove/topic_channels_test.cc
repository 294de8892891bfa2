#include "web/foxglove/topic_channels.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;

TEST(TopicChannels, AreTheTopicsWithTheirSchemas) {
  const auto worlds = std::make_shared<Worlds>();
  SteppedWorld world(worlds);
  const auto watch = worlds->watch({.changed = [] {}});
  auto publisher = world.node().advertise<im::StringMsg>("/said");
  ASSERT_TRUE(world.stepUntil([&] { return !worlds->topics().empty(); }));
  TopicChannels channels(worlds);
  const auto all = channels.all();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].topic, "/said");
  EXPECT_EQ(all[0].schemaName, "ignition.msgs.StringMsg");
  EXPECT_EQ(all[0].schema, channels.schema("ignition.msgs.StringMsg"));
  EXPECT_FALSE(all[0].schema->empty());

  const auto client = std::make_shared<RecordedClient>();
  auto open = all[0].open(client, 3, [](std::uint64_t timeNs) { return std::to_string(timeNs) + ":"; });
  ASSERT_TRUE(world.stepUntil([&] { return publisher.hasSubscribers(); }));
  im::StringMsg message;
  message.set_data("x");
  publisher.publish(message);
  client->free();
  const auto got = client->takeBinaries();
  ASSERT_EQ(got.size(), 1U);
  EXPECT_TRUE(got[0].ends_with(":" + message.SerializeAsString()));
  open.reset();
  EXPECT_TRUE(world.stepUntil([&] { return !publisher.hasSubscribers(); }));
}

}  // namespace
}  // namespace pongsim::web::foxglove
