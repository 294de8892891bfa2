#include "web/foxglove/subscriptions.hh"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/web/recorded_client.hh"
#include "web/foxglove/wire.hh"

namespace pongsim::web::foxglove {
namespace {

using nlohmann::json;

class ChannelsTest : public testing::Test {
 protected:
  Channel channel(const std::string& topic, const void* source = nullptr) {
    Channel made;
    made.topic = topic;
    made.encoding = "protobuf";
    made.schemaName = "T";
    made.schema = std::make_shared<const std::string>("c2NoZW1h");
    made.source = source;
    made.open = [this, topic](const std::shared_ptr<Client>&, std::uint64_t key,
                              const Head& head) -> std::shared_ptr<void> {
      open_[topic] = {key, head(5)};
      return {this, [this, topic](void*) { open_.erase(topic); }};
    };
    return made;
  }
  std::vector<json> sent() {
    std::vector<json> all;
    for (const std::string& text : client_->takeTexts()) all.push_back(json::parse(text));
    return all;
  }

  /// For each topic: its key, and the header of its messages.
  std::map<std::string, std::pair<std::uint64_t, std::string>> open_;
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
  Subscriptions channels_{client_};
};

TEST_F(ChannelsTest, TellsWhatComesAndGoes) {
  channels_.follow({});
  EXPECT_EQ(sent(), (std::vector<json>{{{"op", "advertise"}, {"channels", json::array()}}}));
  channels_.follow({channel("/a"), channel("/b")});
  const auto first = sent();
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0]["channels"][0],
            (json{{"id", 1}, {"topic", "/a"}, {"encoding", "protobuf"}, {"schemaName", "T"}, {"schema", "c2NoZW1h"}}));
  channels_.follow({channel("/a"), channel("/b")});
  EXPECT_TRUE(sent().empty());
  channels_.follow({channel("/b"), channel("/c")});
  EXPECT_EQ(sent()[0], (json{{"op", "unadvertise"}, {"channelIds", {1}}}));
}

TEST_F(ChannelsTest, TellsOfATopicOnceAndAnewWhereItsSourceIsAnother) {
  const int source = 0;
  channels_.follow({channel("/a"), channel("/a", &source)});
  EXPECT_EQ(sent()[0]["channels"].size(), 1U);
  channels_.follow({channel("/a", &source)});
  EXPECT_EQ(sent().size(), 2U);
}

TEST_F(ChannelsTest, OpensAndClosesWhatTheClientSubscribes) {
  channels_.follow({channel("/a"), channel("/b")});
  sent();
  channels_.subscribe(7, 1);
  ASSERT_TRUE(open_.contains("/a"));
  EXPECT_EQ(open_["/a"], (std::pair<std::uint64_t, std::string>(7, dataHead(7, 5))));
  channels_.unsubscribe(7);
  EXPECT_TRUE(open_.empty());
  channels_.subscribe(7, 2);
  channels_.follow({});
  EXPECT_TRUE(open_.empty());
  EXPECT_EQ(sent().size(), 1U);
}

TEST_F(ChannelsTest, SaysWhatCannotBe) {
  channels_.follow({channel("/a"), channel("/b")});
  sent();
  EXPECT_EQ(channels_.subscribe(1, 9), "there is no channel 9");
  EXPECT_EQ(channels_.subscribe(1, 1), "");
  EXPECT_EQ(channels_.subscribe(1, 2), "subscription 1 already exists");
  EXPECT_EQ(channels_.subscribe(2, 1), "channel 1 already has a subscription");
  EXPECT_EQ(channels_.unsubscribe(5), "there is no subscription 5");
}

TEST_F(ChannelsTest, PassesOnWhatTheClientAsksFor) {
  Channel asked = channel("/a");
  json heard;
  asked.ask = [&](const std::shared_ptr<void>& opened, const json& wish) {
    heard = wish;
    return std::string(opened ? "" : "it is not open");
  };
  channels_.follow({asked, channel("/b")});
  channels_.subscribe(1, 1);
  channels_.subscribe(2, 2);
  EXPECT_EQ(channels_.ask(1, {{"width", 3}}), "");
  EXPECT_EQ(heard, (json{{"width", 3}}));
  EXPECT_EQ(channels_.ask(2, {}), "'/b' sends by itself");
  EXPECT_EQ(channels_.ask(3, {}), "there is no subscription 3");
}

}  // namespace
}  // namespace pongsim::web::foxglove
