// What publishers and subscriptions of one transport give each other beside messages in a queue: hearing at once, bulk
// bytes, and who is there.

#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/node.hh"

namespace pongsim {

namespace {

using ignition::msgs::Image;
using ignition::msgs::StringMsg;

StringMsg textOf(const std::string& content) {
  StringMsg message;
  message.set_data(content);
  return message;
}

class HearAtOnce : public testing::Test {
 protected:
  Subscription hear(std::vector<std::string>& heard, const SubscriptionOptions& options = {}) {
    return node_.subscribeAtOnce(
        "/chatter", "ignition.msgs.StringMsg",
        [&heard](const Message& message, const Bulk*) {
          heard.push_back(static_cast<const StringMsg&>(message).data());
        },
        options);
  }

  Transport transport_{{.network = false}};
  Node node_ = transport_.node();
};

/// An image whose pixels are elsewhere, and how often they were written.
struct BulkImage {
  int written = 0;
  Bulk bulk{.size = 6, .write = [this](std::span<std::byte> place) {
              ++written;
              std::ranges::fill(place, std::byte('x'));
            }};
};

Image imageOf(std::uint32_t width) {
  Image image;
  image.set_width(width);
  image.set_pixel_format_type(ignition::msgs::RGB_INT8);
  return image;
}

}  // namespace

TEST_F(HearAtOnce, IsCalledFromWithinPublish) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  std::vector<std::string> heard;
  const Subscription subscription = hear(heard);
  EXPECT_TRUE(publisher.hasSubscribers());
  publisher.publish(textOf("hello"));
  EXPECT_EQ(heard, std::vector<std::string>{"hello"});
  EXPECT_EQ(transport_.dispatch(), 0U);
  EXPECT_EQ(heard.size(), 1U);
  EXPECT_EQ(publisher.sent(), 1U);
}

TEST_F(HearAtOnce, HearsBytesAsAMessage) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  std::vector<std::string> heard;
  const Subscription subscription = hear(heard);
  const std::string bytes = textOf("hello").SerializeAsString();
  publisher.publishBytes(std::as_bytes(std::span(bytes)));
  publisher.publishBytes(std::as_bytes(std::span("\xff\xff")));
  EXPECT_EQ(heard, std::vector<std::string>{"hello"});
}

TEST_F(HearAtOnce, GetsWhatIsLatched) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter", {.latched = true});
  publisher.publish(textOf("before"));
  std::vector<std::string> heard;
  const Subscription subscription = hear(heard);
  transport_.dispatch();
  publisher.publish(textOf("after"));
  EXPECT_EQ(heard, (std::vector<std::string>{"before", "after"}));
}

TEST_F(HearAtOnce, HearsNothingFromItsEndOn) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  std::vector<std::string> heard;
  hear(heard) = {};
  publisher.publish(textOf("hello"));
  EXPECT_TRUE(heard.empty());
  EXPECT_FALSE(publisher.hasSubscribers());
}

TEST_F(HearAtOnce, LeavesOutThePublisherThatItIsToldToLeaveOut) {
  Publisher own = node_.advertise<StringMsg>("/chatter"), other = node_.advertise<StringMsg>("/chatter");
  std::vector<std::string> heard, queued;
  const Subscription subscription = hear(heard, {.except = &own});
  const Subscription inQueue = node_.subscribe<StringMsg>(
      "/chatter", [&](const StringMsg& message) { queued.push_back(message.data()); }, {.except = &own});
  own.publish(textOf("own"));
  other.publish(textOf("other"));
  transport_.dispatch();
  EXPECT_EQ(heard, std::vector<std::string>{"other"});
  EXPECT_EQ(queued, std::vector<std::string>{"other"});
}

TEST_F(HearAtOnce, MayPublishInTurn) {
  Publisher chatter = node_.advertise<StringMsg>("/chatter"), answers = node_.advertise<StringMsg>("/answers");
  std::vector<std::string> heard;
  const Subscription first = node_.subscribeAtOnce(
      "/chatter", "ignition.msgs.StringMsg", [&](const Message& message, const Bulk*) { answers.publish(message); });
  const Subscription second =
      node_.subscribe<StringMsg>("/answers", [&](const StringMsg& message) { heard.push_back(message.data()); });
  chatter.publish(textOf("hello"));
  transport_.dispatch();
  EXPECT_EQ(heard, std::vector<std::string>{"hello"});
}

TEST_F(HearAtOnce, MayEndItsOwnSubscription) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  int calls = 0;
  auto owner = std::make_shared<int>();
  const std::weak_ptr<int> watched = owner;
  Subscription subscription =
      node_.subscribeAtOnce("/chatter", "ignition.msgs.StringMsg", [&, owner](const Message&, const Bulk*) {
        ++calls;
        subscription = {};
        EXPECT_FALSE(watched.expired()) << "the function that runs must not be destroyed";
      });
  owner.reset();
  publisher.publish(textOf("one"));
  publisher.publish(textOf("two"));
  transport_.dispatch();
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(watched.expired());
  EXPECT_FALSE(publisher.hasSubscribers());
}

TEST_F(HearAtOnce, IsGivenTheBulkToWriteItWhereItWants) {
  Publisher publisher = node_.advertise<Image>("/camera");
  std::string pixels;
  const Subscription subscription =
      node_.subscribeAtOnce("/camera", "ignition.msgs.Image", [&](const Message& message, const Bulk* bulk) {
        EXPECT_EQ(static_cast<const Image&>(message).data(), "");
        ASSERT_NE(bulk, nullptr);
        pixels.resize(bulk->size);
        bulk->write(std::as_writable_bytes(std::span(pixels)));
      });
  BulkImage image;
  publisher.publish(imageOf(2), image.bulk);
  EXPECT_EQ(pixels, "xxxxxx");
  // once: nobody else wants it
  EXPECT_EQ(image.written, 1);
}

TEST_F(HearAtOnce, TheBulkIsInTheMessageForOthers) {
  Publisher publisher = node_.advertise<Image>("/camera");
  BulkImage image;
  publisher.publish(imageOf(2), image.bulk);
  EXPECT_EQ(image.written, 0);
  Image got;
  const Subscription subscription = node_.subscribe<Image>("/camera", [&](const Image& message) { got = message; });
  publisher.publish(imageOf(2), image.bulk);
  transport_.dispatch();
  Image expected = imageOf(2);
  expected.set_data("xxxxxx");
  EXPECT_EQ(got.SerializeAsString(), expected.SerializeAsString());
  EXPECT_EQ(image.written, 1);
}

TEST_F(HearAtOnce, ABulkOfNoFieldIsRefused) {
  Publisher publisher = node_.advertise<Image>("/camera");
  BulkImage image;
  for (const char* field : {"no_such", "width"}) {
    image.bulk.field = field;
    EXPECT_THROW(publisher.publish(imageOf(2), image.bulk), std::invalid_argument) << field;
  }
}

TEST_F(HearAtOnce, OwnTopicsAreWhatTheTransportHas) {
  const std::uint64_t atFirst = node_.ownTopicsVersion();
  Publisher publisher = node_.advertise<StringMsg>("/b", {.latched = true});
  const Subscription subscription = node_.subscribe<StringMsg>("/a", [](const StringMsg&) {});
  EXPECT_NE(node_.ownTopicsVersion(), atFirst);
  EXPECT_EQ(node_.ownTopics(), (std::vector<OwnTopic>{{"/a", "ignition.msgs.StringMsg", 0, 1, false},
                                                      {"/b", "ignition.msgs.StringMsg", 1, 0, true}}));
  const std::uint64_t before = node_.ownTopicsVersion();
  EXPECT_EQ(node_.ownTopicsVersion(), before);
  publisher = {};
  EXPECT_NE(node_.ownTopicsVersion(), before);
  EXPECT_EQ(node_.ownTopics().size(), 1U);
}

/// What is heard as bytes, read back.
class HearBytesAtOnce : public HearAtOnce {
 protected:
  template <class M>
  Subscription hearBytes(const std::string& topic, std::vector<M>& heard, const SubscriptionOptions& options = {}) {
    return node_.subscribeBytesAtOnce(
        topic, M::descriptor()->full_name(),
        [&heard](std::size_t size, const std::function<void(std::span<std::byte>)>& write) {
          std::string bytes(size, '?');
          write(std::as_writable_bytes(std::span(bytes)));
          EXPECT_TRUE(heard.emplace_back().ParseFromString(bytes));
        },
        options);
  }
};

TEST_F(HearBytesAtOnce, IsGivenMessagesBytesAndBulkInOneForm) {
  std::vector<Image> heard;
  Publisher publisher = node_.advertise<Image>("/camera");
  const Subscription subscription = hearBytes("/camera", heard);
  BulkImage image;
  publisher.publish(imageOf(2), image.bulk);
  publisher.publish(imageOf(3));
  const std::string bytes = imageOf(4).SerializeAsString();
  publisher.publishBytes(std::as_bytes(std::span(bytes)));
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_EQ(heard[0].data(), "xxxxxx");
  EXPECT_EQ(image.written, 1);
  EXPECT_EQ(heard[1].width(), 3U);
  EXPECT_EQ(heard[2].width(), 4U);
}

TEST_F(HearBytesAtOnce, IsToldLaterWhatWasLatchedBefore) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter", {.latched = true});
  publisher.publish(textOf("hello"));
  std::vector<StringMsg> heard;
  const Subscription subscription = hearBytes("/chatter", heard);
  EXPECT_TRUE(heard.empty());
  transport_.dispatch();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].data(), "hello");
}

TEST_F(HearAtOnce, WhoRelaysDoesNotHearWhoRelays) {
  Publisher relay = node_.advertise<StringMsg>("/chatter", {.relays = true});
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  std::vector<std::string> carried, heard, queued;
  const Subscription carrier = hear(carried, {.relays = true});
  EXPECT_FALSE(relay.hasSubscribers());
  EXPECT_TRUE(publisher.hasSubscribers());
  const Subscription listener = hear(heard);
  const Subscription slow = node_.subscribe<StringMsg>(
      "/chatter", [&queued](const StringMsg& message) { queued.push_back(message.data()); }, {.relays = true});
  relay.publish(textOf("from outside"));
  publisher.publish(textOf("from here"));
  const std::string bytes = textOf("bytes").SerializeAsString();
  relay.publishBytes(std::as_bytes(std::span(bytes)));
  transport_.dispatch();
  EXPECT_EQ(carried, std::vector<std::string>{"from here"});
  EXPECT_EQ(queued, std::vector<std::string>{"from here"});
  EXPECT_EQ(heard, (std::vector<std::string>{"from outside", "from here", "bytes"}));
}

TEST_F(HearAtOnce, OwnTopicsAreWithoutThoseThatRelay) {
  const std::uint64_t atFirst = node_.ownTopicsVersion();
  const Publisher relay = node_.advertise<StringMsg>("/a", {.relays = true});
  const Subscription carrier =
      node_.subscribe<StringMsg>("/b", [](const StringMsg&) {}, {.relays = true, .ownOnly = true});
  EXPECT_EQ(node_.ownTopicsVersion(), atFirst);
  EXPECT_TRUE(node_.ownTopics().empty());
  EXPECT_THROW(node_.advertise<StringMsg>("/a", {.latched = true, .relays = true}), std::invalid_argument);
}

TEST_F(HearAtOnce, OwnTopicsTellOfWhoTakesAnyType) {
  const std::uint64_t atFirst = node_.ownTopicsVersion();
  const Subscription any = node_.subscribeAnyType("/a", [](auto, auto) {});
  EXPECT_NE(node_.ownTopicsVersion(), atFirst);
  EXPECT_EQ(node_.ownTopics(), (std::vector<OwnTopic>{{"/a", "*", 0, 1, false}}));
}

}  // namespace pongsim
