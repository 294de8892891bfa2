#include "shared/sockets/senders.hh"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>

namespace pongsim::shared {
namespace {

/// Two sockets of this machine, of which one sends to the other by 127.0.0.2.
class SendersTest : public testing::Test {
 protected:
  SendersTest() {
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_addr.s_addr = inet_addr("127.0.0.2");
    bind(receiver_, reinterpret_cast<const sockaddr*>(&name), sizeof name);
    socklen_t size = sizeof name;
    getsockname(receiver_, reinterpret_cast<sockaddr*>(&name), &size);
    connect(sender_, reinterpret_cast<const sockaddr*>(&name), sizeof name);
  }
  ~SendersTest() override {
    close(receiver_);
    close(sender_);
  }

  /// @return Whether what is sent arrives: on one machine at once.
  bool hears(const std::string& word = "abc") {
    std::array<char, 3> received{};
    send(sender_, word.data(), word.size(), 0);
    return recv(receiver_, received.data(), received.size(), MSG_DONTWAIT) == static_cast<ssize_t>(word.size());
  }

  int receiver_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  int sender_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

TEST_F(SendersTest, AreAlwaysThoseOfLoopback) {
  EXPECT_TRUE(hears());
  ASSERT_TRUE(limitSenders(receiver_, {}));
  EXPECT_TRUE(hears());
  ASSERT_TRUE(limitSenders(receiver_, {.addresses = {inet_addr("10.1.2.3"), inet_addr("10.1.2.4")}}));
  EXPECT_TRUE(hears());
  ASSERT_TRUE(limitSenders(receiver_, {.addresses = {}, .openAddress = inet_addr("10.1.2.3")}));
  EXPECT_TRUE(hears());
}

TEST_F(SendersTest, CanBeNobody) {
  ASSERT_TRUE(refuseSenders(receiver_));
  EXPECT_FALSE(hears());
}

TEST_F(SendersTest, AreLimitedInNumber) {
  EXPECT_TRUE(limitSenders(receiver_, {.addresses = std::vector<std::uint32_t>(Senders::kMostAddresses, 1)}));
  EXPECT_TRUE(hears());
  EXPECT_FALSE(limitSenders(receiver_, {.addresses = std::vector<std::uint32_t>(Senders::kMostAddresses + 1, 1)}));
}

TEST_F(SendersTest, SendWhatIsOfNoRefusedKind) {
  for (const Senders& senders : {Senders{}, Senders{.addresses = {}, .isAnybody = true}}) {
    ASSERT_TRUE(limitSenders(receiver_, senders, RefusedKind{.offset = 1, .tag = 'b', .least = 'c'}));
    for (const char* kept : {"abb", "acc", "bcd", "ab", "a", ""}) EXPECT_TRUE(hears(kept)) << kept;
    for (const char* refused : {"abc", "abz"}) EXPECT_FALSE(hears(refused)) << refused;
  }
}

}  // namespace
}  // namespace pongsim::shared
