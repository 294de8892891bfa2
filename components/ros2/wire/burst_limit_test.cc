#include "ros2/wire/burst_limit.hh"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <thread>
#include <vector>

namespace pongsim::ros2 {
namespace {

constexpr std::size_t kPacket = 60'000;

/// A reader's socket, with a default buffer.
class BurstLimitTest : public testing::Test {
 protected:
  BurstLimitTest() {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(reader_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_), 0);
    socklen_t size = sizeof address_;
    EXPECT_EQ(getsockname(reader_, reinterpret_cast<sockaddr*>(&address_), &size), 0);
  }
  ~BurstLimitTest() override {
    close(reader_);
    close(sender_);
  }

  std::uint32_t address() const { return address_.sin_addr.s_addr; }
  std::uint16_t port() const { return ntohs(address_.sin_port); }
  void send() {
    const std::vector<char> bytes(kPacket);
    EXPECT_EQ(
        sendto(sender_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address_), sizeof address_),
        static_cast<ssize_t>(kPacket));
  }
  void read() {
    std::vector<char> bytes(kPacket);
    EXPECT_EQ(recv(reader_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(kPacket));
  }

  int reader_ = socket(AF_INET, SOCK_DGRAM, 0);
  int sender_ = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address_{};
};

TEST_F(BurstLimitTest, LosesNothingToAReaderThatReads) {
  constexpr int kPackets = 200;
  std::thread reading([this] {
    for (int i = 0; i < kPackets; ++i) read();
  });
  BurstLimit limit;
  for (int i = 0; i < kPackets; ++i) {
    // a reader that is not scheduled for long is waited for again
    while (!limit.awaitRoom(address(), port(), kPacket)) std::this_thread::yield();
    send();
  }
  reading.join();
}

TEST_F(BurstLimitTest, DoesNotWaitForAReaderWithALargerBuffer) {
  // twice as much is what it gets
  const int size = 20 * kPacket;
  ASSERT_EQ(setsockopt(reader_, SOL_SOCKET, SO_RCVBUFFORCE, &size, sizeof size), 0);
  BurstLimit limit;
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(limit.awaitRoom(address(), port(), kPacket));
    send();
  }
}

TEST_F(BurstLimitTest, GivesUpOnAReaderThatDoesNotRead) {
  BurstLimit limit;
  const auto sendAll = [&](int packets) {
    int withRoom = 0;
    for (int i = 0; i < packets; ++i) {
      withRoom += limit.awaitRoom(address(), port(), kPacket) ? 1 : 0;
      send();
    }
    return withRoom;
  };
  // three of 208 KiB
  EXPECT_EQ(sendAll(4), 3);
  // not waited for again at once
  EXPECT_EQ(sendAll(3), 0);
  // small packets are never held up
  EXPECT_TRUE(limit.awaitRoom(address(), port(), 1000));
}

}  // namespace
}  // namespace pongsim::ros2
