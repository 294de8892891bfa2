#include "transport/inbox.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "transport/channel.hh"
#include "transport/dispatch_queue.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

namespace {

class InboxTest : public testing::Test {
 protected:
  Inbox inbox(const SubscriptionOptions& options) {
    return {channel_, queue_, [](const Message&) {}, options};
  }

  /// @return How many are dropped for it.
  std::size_t add(Inbox& places, std::uint64_t number, std::size_t bytes = 0) {
    std::vector<Parcel*> dropped;
    places.add(number, pool_.take(spare_, bytes), false, dropped);
    return dropped.size();
  }

  SpareParcels spare_, spareNumbers_;
  Channel channel_{"/chatter", "ignition.msgs.StringMsg", spare_};
  Channel numbers_{"/number", "ignition.msgs.Double", spareNumbers_};
  DispatchQueue queue_;
  ParcelPool pool_;
};

}  // namespace

TEST_F(InboxTest, DropsTheOldestWhenItIsFull) {
  Inbox places = inbox({.queueLength = 3});
  for (std::uint64_t number = 0; number < 10; ++number) EXPECT_EQ(add(places, number), number >= 3 ? 1 : 0);
  EXPECT_EQ(places.dropped(), 7);
  EXPECT_EQ(places.received(), 3);
  std::vector<Arrival> arrivals;
  places.moveTo(arrivals);
  ASSERT_EQ(arrivals.size(), 3);
  EXPECT_EQ(arrivals[0].number, 7);
  EXPECT_EQ(arrivals[2].number, 9);
  EXPECT_EQ(places.size(), 0);
  EXPECT_EQ(add(places, 10), 0);
}

TEST_F(InboxTest, KeepsNoMoreBytesThanItMayButOneMessage) {
  Inbox places = inbox({});
  constexpr std::size_t kLarge = 30 << 20;
  EXPECT_EQ(add(places, 0, kLarge), 0);
  EXPECT_EQ(add(places, 1, kLarge), 0);
  EXPECT_EQ(add(places, 2, kLarge), 1);
  EXPECT_EQ(add(places, 3, 100 << 20), 2);
  EXPECT_EQ(places.size(), 1);
  EXPECT_EQ(add(places, 4, 1), 1);
  EXPECT_EQ(places.dropped(), 4);
}

TEST_F(InboxTest, HoldsOneMessageAtLeast) {
  Inbox places = inbox({.queueLength = 0});
  EXPECT_EQ(add(places, 0), 0);
  EXPECT_EQ(places.size(), 1);
}

TEST_F(InboxTest, SaysWhenBytesAreNoMessage) {
  Inbox places = inbox({});
  Parcel* parcel = pool_.take(spare_, 5);
  std::ranges::fill(parcel->bytes->bytes, std::byte{0xff});
  EXPECT_EQ(places.handOver(*parcel), "is not of type ignition.msgs.StringMsg");
  std::size_t size = 0;
  Inbox raw(channel_, queue_, [&size](std::span<const std::byte> bytes) { size = bytes.size(); }, {});
  EXPECT_EQ(raw.handOver(*parcel), std::nullopt);
  EXPECT_EQ(size, 5);
  EXPECT_EQ(places.handOver(*pool_.take(spare_, 0)), std::nullopt);
}

TEST_F(InboxTest, RefusesNumbersBeyondTheLargest) {
  std::vector<std::string> heard;
  const auto note = [&heard](const Message& message) { heard.push_back(message.ShortDebugString()); };
  Inbox commands(numbers_, queue_, note, kCommands);
  Inbox all(numbers_, queue_, note, {});
  const auto handTo = [this](Inbox& inbox, const char* text) {
    const MessagePointer message = newMessage("ignition.msgs.Double");
    EXPECT_EQ(parseMessage(text, *message), std::nullopt);
    Parcel* bytes = pool_.take(spareNumbers_, message->ByteSizeLong());
    message->SerializeToArray(bytes->bytes->bytes.data(), static_cast<int>(bytes->bytes->bytes.size()));
    return inbox.handOver(*bytes);
  };
  EXPECT_EQ(handTo(commands, "data: 1e6"), std::nullopt);
  EXPECT_EQ(handTo(commands, "data: -1e308"),
            "is refused: data is -1e+308; numbers must be finite, from -1e+06 to 1e+06");
  EXPECT_EQ(handTo(commands, "data: nan"), "is refused: data is nan; numbers must be finite, from -1e+06 to 1e+06");
  EXPECT_EQ(handTo(all, "data: -1e308"), std::nullopt);
  EXPECT_EQ(heard, (std::vector<std::string>{"data: 1000000", "data: -1e+308"}));
}

}  // namespace pongsim::transport
