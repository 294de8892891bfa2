#include "web/system/traffic_channel.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/web/recorded_client.hh"

namespace pongsim::web {
namespace {

using nlohmann::json;

TEST(TrafficChannel, TellsWhatHasBeenSentToWhomWhenAsked) {
  const auto book = std::make_shared<TrafficBook>();
  TrafficChannel channel(book);
  const auto client = std::make_shared<RecordedClient>();
  const auto other = book->add("192.0.2.7", "foxglove.sdk.v1");
  other->name(4, "/image");
  other->add(4, 900);
  const auto opened = channel.open(client, 1, [](std::uint64_t) { return std::string("head"); });
  client->free();
  EXPECT_TRUE(client->takeBinaries().empty());
  EXPECT_EQ(channel.ask(opened, {}), "");
  client->free();
  const std::vector<std::string> sent = client->takeBinaries();
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(
      json::parse(sent[0].substr(4)),
      json::parse(R"({"clients": [{"number": 1, "address": "192.0.2.7", "protocol": "foxglove.sdk.v1", "isYou": false,
                                         "topics": {"/image": [1, 900]}}]})"));
}

}  // namespace
}  // namespace pongsim::web
