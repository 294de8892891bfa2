#include "transport/inbox.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include "transport/bus.hh"
#include "transport/endpoint.hh"

namespace pongsim::transport {

namespace {

class InboxTest : public testing::Test {
 protected:
  Inbox inbox(std::size_t limit) {
    return {channel_, newMessage("ignition.msgs.StringMsg"), [](const Message&) {}, limit};
  }

  Channel channel_{"/chatter", "ignition.msgs.StringMsg"};
  BufferPool pool_;
};

}  // namespace

TEST_F(InboxTest, DropsTheOldestWhenItIsFull) {
  Inbox places = inbox(3);
  for (std::uint64_t number = 0; number < 10; ++number) {
    Buffer* oldest = places.add(number, pool_.take());
    EXPECT_EQ(oldest != nullptr, number >= 3);
  }
  EXPECT_EQ(places.dropped(), 7);
  std::vector<Arrival> arrivals;
  places.moveTo(arrivals);
  ASSERT_EQ(arrivals.size(), 3);
  EXPECT_EQ(arrivals[0].number, 7);
  EXPECT_EQ(arrivals[2].number, 9);
  EXPECT_EQ(places.size(), 0);
}

TEST_F(InboxTest, HoldsOneMessageAtLeast) {
  Inbox places = inbox(0);
  EXPECT_EQ(places.add(0, pool_.take()), nullptr);
  EXPECT_EQ(places.size(), 1);
}

TEST_F(InboxTest, SaysWhenBytesAreNoMessage) {
  Inbox places = inbox(1);
  Buffer* buffer = pool_.take();
  buffer->bytes.assign(5, std::byte{0xff});
  EXPECT_FALSE(places.parse(*buffer));
  buffer->bytes.clear();
  EXPECT_TRUE(places.parse(*buffer));
}

}  // namespace pongsim::transport
