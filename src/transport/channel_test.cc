#include "transport/channel.hh"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "transport/dispatch_queue.hh"
#include "transport/inbox.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

namespace {

class ChannelTest : public testing::Test {
 protected:
  std::unique_ptr<Inbox> inbox(DispatchQueue& queue, const SubscriptionOptions& options = {}) {
    return std::make_unique<Inbox>(
        channel_, queue, [](std::span<const std::byte>) {}, options);
  }

  std::unique_ptr<Inbox> inboxAtOnce(DispatchQueue& queue) {
    return std::make_unique<Inbox>(
        channel_, queue, [](const Message&, const Bulk*) {}, SubscriptionOptions());
  }

  void add(Inbox& inbox) {
    channel_.atOnce.push_back(&inbox);
    channel_.countSubscription(inbox, 1);
    channel_.countAtOnceQueues();
  }

  SpareParcels spare_;
  Channel channel_{"/chatter", "ignition.msgs.StringMsg", spare_};
  DispatchQueue own_, others_;
};

}  // namespace

TEST_F(ChannelTest, CountsPublishersInTotalAndByTransport) {
  PublisherOptions latched;
  latched.latched = true;
  channel_.countPublisher(own_, latched, 1);
  channel_.countPublisher(others_, {}, 1);
  EXPECT_EQ(channel_.users.publishers, 2);
  EXPECT_EQ(channel_.users.latchedPublishers, 1);
  EXPECT_EQ(channel_.usersOf[&own_].publishers, 1);
  EXPECT_EQ(channel_.usersOf[&others_].latchedPublishers, 0);
  channel_.countPublisher(own_, latched, -1);
  EXPECT_EQ(channel_.users.publishers, 1);
  EXPECT_EQ(channel_.users.latchedPublishers, 0);
}

TEST_F(ChannelTest, ChangesTheVersionOfTheTransportsTopicsButForRelays) {
  PublisherOptions relays;
  relays.relays = true;
  channel_.countPublisher(own_, relays, 1);
  EXPECT_EQ(own_.ownTopicsVersion, 0);
  channel_.countPublisher(own_, {}, 1);
  EXPECT_EQ(own_.ownTopicsVersion, 1);
  EXPECT_EQ(others_.ownTopicsVersion, 0);
}

TEST_F(ChannelTest, CountsSubscriptionsAtOnceApart) {
  const auto ordinary = inbox(own_);
  const auto atOnce = inboxAtOnce(own_);
  channel_.countSubscription(*ordinary, 1);
  channel_.countSubscription(*atOnce, 1);
  EXPECT_EQ(channel_.inboxCount, 1);
  EXPECT_EQ(channel_.atOnceCount, 1);
  EXPECT_EQ(channel_.users.subscriptions, 2);
  EXPECT_EQ(channel_.usersOf[&own_].subscriptions, 2);
}

TEST_F(ChannelTest, NeedsInboxesForOrdinarySubscriptionsAndLatchedMessages) {
  EXPECT_FALSE(channel_.needsInboxes(own_, {}));
  PublisherOptions latched;
  latched.latched = true;
  EXPECT_TRUE(channel_.needsInboxes(own_, latched));
  const auto ordinary = inbox(own_);
  channel_.countSubscription(*ordinary, 1);
  EXPECT_TRUE(channel_.needsInboxes(own_, {}));
}

TEST_F(ChannelTest, NeedsInboxesForSubscriptionsAtOnceOfOtherTransportsOnly) {
  const auto atOnce = inboxAtOnce(own_);
  add(*atOnce);
  EXPECT_FALSE(channel_.needsInboxes(own_, {}));
  EXPECT_TRUE(channel_.needsInboxes(others_, {}));
  PublisherOptions ownOnly;
  ownOnly.ownOnly = true;
  EXPECT_FALSE(channel_.needsInboxes(others_, ownOnly));
  const auto second = inboxAtOnce(others_);
  add(*second);
  EXPECT_TRUE(channel_.needsInboxes(own_, {}));
  // without the first one, the other's is left
  std::erase(channel_.atOnce, atOnce.get());
  channel_.countAtOnceQueues();
  EXPECT_TRUE(channel_.needsInboxes(own_, {}));
  EXPECT_FALSE(channel_.needsInboxes(others_, {}));
}

}  // namespace pongsim::transport
