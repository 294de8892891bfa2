#include "web/foxglove/graph.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;

using GraphTest = SessionTest;

TEST_F(GraphTest, TellsAllAndThenWhatHasChanged) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  Subscription subscription = world_.node().subscribe<im::StringMsg>("/asked", [](const auto&) {});
  Service offered = world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const auto&, auto&) { return true; });
  open();
  ASSERT_FALSE(service("/s").is_null());
  say({{"op", "subscribeConnectionGraph"}});
  const json all = await("connectionGraphUpdate");
  EXPECT_EQ(all["publishedTopics"], (json{{{"name", "/said"}, {"publisherIds", {"w/1"}}}}));
  EXPECT_EQ(all["subscribedTopics"], (json{{{"name", "/asked"}, {"subscriberIds", {"w/1"}}}}));
  EXPECT_EQ(all["advertisedServices"], (json{{{"name", "/s"}, {"providerIds", {"w/1"}}}}));
  offered = {};
  publisher = {};
  const json change = await("connectionGraphUpdate");
  EXPECT_EQ(change["subscribedTopics"], json::array());
  EXPECT_TRUE(change["removedTopics"] == json{"/said"} || change["removedServices"] == json{"/s"}) << change;
  say({{"op", "unsubscribeConnectionGraph"}});
  subscription = {};
  ASSERT_EQ(await("unadvertise").value("op", ""), "unadvertise");
}

}  // namespace
}  // namespace pongsim::web::foxglove
