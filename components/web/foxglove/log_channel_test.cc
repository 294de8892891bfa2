#include "web/foxglove/log_channel.hh"

#include <foxglove/log.pb.h>
#include <gtest/gtest.h>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

class LogOfferTest : public SessionTest {};

TEST_F(LogOfferTest, IsAChannelOfWarningsForAllClients) {
  const Logger speaker("tests");
  speaker.warning("before");
  for (const char* protocol : {"foxglove.websocket.v1", "pongsim.web.v1"}) {
    open(protocol);
    const json offered = channel("/foxglove/log");
    EXPECT_EQ(offered["schemaName"], "foxglove.Log") << protocol;
    say({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", offered["id"]}}}}});
    ::foxglove::Log message;
    // after the subscription id and the time
    ASSERT_TRUE(message.ParseFromString(awaitBinary('\1').substr(12)));
    EXPECT_EQ(message.message(), "before");
    EXPECT_EQ(message.name(), "tests");
    EXPECT_EQ(message.level(), ::foxglove::Log::WARNING);
    EXPECT_GT(message.timestamp().seconds(), 0);
  }
  speaker.error("now");
  ::foxglove::Log message;
  ASSERT_TRUE(message.ParseFromString(awaitBinary('\1').substr(12)));
  EXPECT_EQ(message.message(), "now");
  EXPECT_EQ(message.level(), ::foxglove::Log::ERROR);
}

}  // namespace
}  // namespace pongsim::web::foxglove
