#include "ros2/wire/receive_buffer.hh"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <vector>

namespace pongsim::ros2 {
namespace {

constexpr std::size_t kSent = 50'000;

class ReceiveBufferTest : public testing::Test {
 protected:
  ReceiveBufferTest() {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(reader_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_), 0);
    socklen_t size = sizeof address_;
    EXPECT_EQ(getsockname(reader_, reinterpret_cast<sockaddr*>(&address_), &size), 0);
  }
  ~ReceiveBufferTest() override { close(reader_); }

  std::uint32_t address() const { return address_.sin_addr.s_addr; }
  std::uint16_t port() const { return ntohs(address_.sin_port); }
  void send() {
    const std::vector<char> bytes(kSent);
    const auto* const to = reinterpret_cast<const sockaddr*>(&address_);
    EXPECT_EQ(sendto(reader_, bytes.data(), bytes.size(), 0, to, sizeof address_), static_cast<ssize_t>(kSent));
  }
  void read() {
    std::vector<char> bytes(kSent);
    EXPECT_EQ(recv(reader_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(kSent));
  }

  int reader_ = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address_{};
};

TEST_F(ReceiveBufferTest, IsKnownWithItsUse) {
  constexpr int kSize = 100'000;
  ASSERT_EQ(setsockopt(reader_, SOL_SOCKET, SO_RCVBUF, &kSize, sizeof kSize), 0);
  const auto empty = receiveBufferOf(address(), port());
  ASSERT_TRUE(empty);
  // the kernel doubles it for its administration
  EXPECT_EQ(empty->size, 2U * kSize);
  EXPECT_EQ(empty->used, 0U);
  send();
  EXPECT_GE(receiveBufferOf(address(), port())->used, kSent);
  read();
  EXPECT_EQ(receiveBufferOf(address(), port())->used, 0U);
}

TEST_F(ReceiveBufferTest, IsKnownByProcAsWell) {
  EXPECT_EQ(receiveBufferByProc(port())->used, 0U);
  send();
  EXPECT_GE(receiveBufferByProc(port())->used, kSent);
}

TEST_F(ReceiveBufferTest, IsNotKnownWithoutASocket) { EXPECT_FALSE(receiveBufferOf(address(), 0)); }

}  // namespace
}  // namespace pongsim::ros2
