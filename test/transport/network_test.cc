#include "transport/network.hh"

#include <arpa/inet.h>
#include <fastdds/rtps/writer/RTPSWriter.h>
#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "transport/domain.hh"

namespace pongsim::transport {

namespace {

using ignition::msgs::StringMsg;

constexpr const char* kTopic = "/chatter";
constexpr const char* kType = "ignition.msgs.StringMsg";

/// Another participant, that sends what it likes.
class Sender {
 public:
  Sender() : network_(test::testDomain()) {
    writer_ = network_.makeWriter(kTopic, kType, [this] {
      const std::lock_guard lock(mutex_);
      changed_.notify_all();
    });
  }
  ~Sender() { network_.end(std::move(writer_)); }

  bool waitForReaders() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, test::kDeadline, [this] { return writer_->hasReaders(); });
  }

  std::uint64_t dropped() const { return writer_->dropped(); }

  /// @param damage Done to the frame's eight bytes.
  void send(const std::string& bytes, const std::function<void(std::byte*)>& damage) {
    writer_->write(bytes.size(), [&](std::span<std::byte> place) {
      std::ranges::copy(std::as_bytes(std::span(bytes)), place.begin());
      damage(place.data() - 8);
    });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  Network network_;
  std::unique_ptr<Writer> writer_;
};

void noDamage(std::byte*) {}

/// A program of another kind that listens at a discovery port.
class Stranger {
 public:
  Stranger(std::uint32_t address, std::uint32_t port) : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(address);
    place.sin_port = htons(static_cast<std::uint16_t>(port));
    EXPECT_EQ(bind(descriptor_, reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);
  }
  ~Stranger() { close(descriptor_); }

  /// @return The first four bytes of what comes.
  std::string hear() {
    pollfd waited{descriptor_, POLLIN, 0};
    std::array<char, 4> begin{};
    if (poll(&waited, 1, 60'000) != 1 || recv(descriptor_, begin.data(), begin.size(), 0) != 4) return "nothing";
    return {begin.begin(), begin.end()};
  }

 private:
  int descriptor_;
};

}  // namespace

TEST(Network, DropsWhatIsNoMessageAndSaysWhoSentIt) {
  test::testDomain();
  Transport transport;
  std::string heard;
  const Subscription subscription =
      transport.node().subscribe<StringMsg>(kTopic, [&](const StringMsg& message) { heard += message.data(); });
  Sender sender;
  ASSERT_TRUE(sender.waitForReaders());

  StringMsg good;
  good.set_data("good");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 50; ++i) sender.send(std::string(37, '\xff'), noDamage);
  sender.send(good.SerializeAsString().substr(0, 4), noDamage);
  sender.send(good.SerializeAsString(), [](std::byte* frame) { frame[1] = std::byte{9}; });
  sender.send(good.SerializeAsString(), [](std::byte* frame) { frame[7] = std::byte{0xff}; });
  sender.send(good.SerializeAsString(), [](std::byte* frame) { frame[4] = std::byte{200}; });
  sender.send(good.SerializeAsString(), noDamage);
  const auto deadline = std::chrono::steady_clock::now() + test::kDeadline;
  while (heard.empty() && std::chrono::steady_clock::now() < deadline) transport.dispatchFor(test::kDeadline);
  const std::string said = testing::internal::GetCapturedStderr();

  EXPECT_EQ(heard, "good");
  EXPECT_NE(said.find(kTopic), std::string::npos) << said;
  EXPECT_NE(said.find("process " + std::to_string(getpid())), std::string::npos) << said;
  EXPECT_LT(std::count(said.begin(), said.end(), '\n'), 20) << "more than the rate allows";
}

TEST(Network, AnnouncesItselfToAllWhoListenOnThisMachine) {
  const int domain = test::testDomain();
  const std::uint32_t first = discoveryPorts(domain).first;
  Stranger near(INADDR_LOOPBACK, first + 20);
  Stranger far(INADDR_ANY, first + 200);
  const auto open = openDiscoveryPorts(domain);
  ASSERT_TRUE(open);
  ASSERT_EQ(open->size(), 2);
  EXPECT_EQ((*open)[0].port + (*open)[1].port, 2 * first + 220);
  EXPECT_NE((*open)[0].isOnLoopbackAlone, (*open)[1].isOnLoopbackAlone);
  Network network(domain);
  EXPECT_EQ(near.hear(), "RTPS");
  EXPECT_EQ(far.hear(), "RTPS");
}

TEST(Network, KeepsNoMoreForASlowReaderThanItMay) {
  test::testDomain();
  test::Process listener({TRANSPORT_PEER, "listen", kTopic});
  ASSERT_TRUE(listener.waitForOutput("ready"));
  Sender sender;
  ASSERT_TRUE(sender.waitForReaders());
  listener.kill(SIGSTOP);
  StringMsg message;
  message.set_data(std::string(1 << 20, 'x'));
  const std::string bytes = message.SerializeAsString();
  for (int i = 0; i < 64; ++i) sender.send(bytes, noDamage);
  message.set_data("the end");
  sender.send(message.SerializeAsString(), noDamage);
  listener.kill(SIGCONT);
  EXPECT_TRUE(listener.waitForOutput("got the end"));
  EXPECT_GT(sender.dropped(), 0);
}

}  // namespace pongsim::transport
