#include "transport/network/network.hh"

#include <fastdds/rtps/writer/RTPSWriter.h>
#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "hostile/neighbour.hh"
#include "hostile/packet.hh"
#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/udp_socket.hh"
#include "support/wait_until.hh"
#include "transport/udp/domain.hh"

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

/// A participant that is nothing but its messages.
class Stranger {
 public:
  explicit Stranger(const hostile::Foothold& foothold, int number) : foothold_(foothold) {
    prefix_ = {1, 15, 7, 7, static_cast<std::uint8_t>(number)};
  }

  void announce(std::uint16_t port) const {
    constexpr std::uint16_t kLease = 0x02, kAddress = 0x31, kDiscoveryAddress = 0x32, kParticipantGuid = 0x50,
                            kBuiltinEndpoints = 0x58;
    constexpr std::uint32_t kLoopback = 0x7f000001, kDiscovery = 0x3f;
    hostile::Packet packet(prefix_);
    packet.beginData(hostile::entity::kSpdpReader, hostile::entity::kSpdpWriter, 1, hostile::kWithData);
    packet.add32(0x00000300);
    packet.addGuid(kParticipantGuid, prefix_, hostile::entity::kParticipant);
    packet.addNumberParameter(kBuiltinEndpoints, kDiscovery);
    packet.addLocator(kDiscoveryAddress, kLoopback, foothold_.port());
    packet.addLocator(kAddress, kLoopback, foothold_.port());
    packet.beginParameter(kLease);
    packet.add32(20);
    packet.add32(0);
    packet.endParameter();
    packet.addSentinel();
    packet.end();
    foothold_.send(packet.bytes(), port);
  }

  /// Asks for samples of the other's publishers again.
  void askFor(std::int64_t first, std::uint32_t number, std::uint16_t port) const {
    hostile::Packet packet(prefix_);
    packet.begin(hostile::Kind::kAckNack);
    packet.addEntity(hostile::entity::kPublicationsReader);
    packet.addEntity(hostile::entity::kPublicationsWriter);
    packet.addSequenceSet(first, number);
    packet.add32(1);
    packet.end();
    foothold_.send(packet.bytes(), port);
  }

  void leave(std::uint16_t port) const { foothold_.send(hostile::goodbye(prefix_).bytes(), port); }

 private:
  const hostile::Foothold& foothold_;
  hostile::Prefix prefix_{};
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
  // programs of another kind
  test::UdpSocket near(INADDR_LOOPBACK, first + 20);
  test::UdpSocket far(INADDR_ANY, first + 200);
  const Network network(domain);
  EXPECT_EQ(near.hearBeginning(), "RTPS");
  EXPECT_EQ(far.hearBeginning(), "RTPS");
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

// Fast DDS 2.9 has two threads wait for each other for ever where a participant leaves while it is sent again what
// tells of an endpoint's end.
TEST(Network, LosesANeighbourThatStillAsksForWhatHasEnded) {
  constexpr int kEach = 100;
  const int domain = test::testDomain();
  Network network(domain);
  hostile::Foothold foothold(domain);
  network.announce();
  const auto neighbours = foothold.hear(std::chrono::milliseconds(0), test::kDeadline);
  ASSERT_EQ(neighbours.size(), 1U);
  const std::uint16_t port = neighbours.front().discoveryPort;
  for (int i = 0; i < 200 && !HasFailure(); ++i) {
    std::vector<std::unique_ptr<Writer>> writers;
    for (int k = 0; k < kEach; ++k) writers.push_back(network.makeWriter(kTopic, kType, nullptr));
    const Stranger stranger(foothold, i);
    const auto changes = [&](auto&& act) {
      const std::uint64_t before = network.directory().version();
      act();
      return test::waitUntil([&] { return network.directory().version() > before; });
    };
    EXPECT_TRUE(changes([&] { stranger.announce(port); }));
    for (auto& each : writers) network.end(std::move(each));
    // the first one is the census's
    stranger.askFor(2 * kEach * i + kEach + 2, kEach, port);
    std::this_thread::sleep_for(std::chrono::microseconds(i % 40 * 15));  // the answer comes about now
    EXPECT_TRUE(changes([&] { stranger.leave(port); }));
  }
}

TEST(Network, IsFoundWhenItIsAnnounced) {
  Network other(test::testDomain());
  Network later(test::testDomain(), std::nullopt, true);
  auto writer = later.makeWriter(kTopic, kType, nullptr);
  later.announce();
  EXPECT_TRUE(other.directory().waitForTopic(kTopic, Role::kPublisher, deadlineAfter(test::kDeadline)));
  later.end(std::move(writer));
}

TEST(Network, IsFoundAfterManyOthersOfItsProcess) {
  Network other(test::testDomain());
  // more than a domain has ports
  for (std::uint32_t i = 0; i < discoveryPorts(test::testDomain()).count + 5; ++i) {
    Network one(test::testDomain());
    one.end(one.makeWriter(kTopic, kType, nullptr));
  }
  Network last(test::testDomain());
  auto writer = last.makeWriter(kTopic, kType, nullptr);
  EXPECT_TRUE(other.directory().waitForTopic(kTopic, Role::kPublisher, deadlineAfter(test::kDeadline)));
  last.end(std::move(writer));
}

TEST(Network, AnnouncesItselfInTheEnd) {
  Network other(test::testDomain());
  Network later(test::testDomain(), std::nullopt, true);
  auto writer = later.makeWriter(kTopic, kType, nullptr);
  EXPECT_TRUE(other.directory().waitForTopic(kTopic, Role::kPublisher, deadlineAfter(test::kDeadline)));
  later.end(std::move(writer));
}

/// A network with so many endpoints that it has three participants.
class ManyEndpoints : public testing::Test {
 protected:
  static constexpr int kTopics = 2500;

  static std::string topic(int number) { return "/many/" + std::to_string(number); }

  ManyEndpoints() {
    for (int i = 0; i < kTopics; ++i) writers_.push_back(many_.makeWriter(topic(i), kType, nullptr));
  }
  ~ManyEndpoints() override {
    for (auto& each : writers_) many_.end(std::move(each));
  }

  int domain_ = test::testDomain();
  Network many_{domain_};
  std::vector<std::unique_ptr<Writer>> writers_;
};

TEST_F(ManyEndpoints, AreSpreadOverParticipantsThatDoNotKnowOfEachOther) {
  const auto open = openDiscoveryPorts(domain_);
  if (!open) GTEST_SKIP() << "this system does not tell who listens";
  EXPECT_EQ(open->size(), 3U);
  std::set<ParticipantId> participants;
  for (const auto& each : writers_) participants.insert(each->participant());
  EXPECT_EQ(participants.size(), 3U);
  EXPECT_TRUE(many_.discover(test::kDeadline)) << "there is nobody else";
  EXPECT_TRUE(many_.directory().topics().empty());
}

TEST_F(ManyEndpoints, AreAllFoundByOthersAsOneProcess) {
  Network other(domain_);
  ASSERT_TRUE(other.discover(test::kDeadline));
  EXPECT_EQ(other.directory().topics().size(), static_cast<std::size_t>(kTopics));
  EXPECT_EQ(other.directory().topic(topic(kTopics - 1)).publishers,
            (std::vector<TopicInfo::Endpoint>{{kType, static_cast<int>(getpid())}}));
}

TEST_F(ManyEndpoints, ReachTheirReadersAndReportTheirTraffic) {
  const std::string last = topic(kTopics - 1);
  many_.reportTraffic([&] {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return TrafficReport{now, {{last, kType, Role::kPublisher, 7, 0}}};
  });
  Network other(domain_);
  std::atomic<int> received = 0;
  auto reader = other.makeReader(last, kType, [&](const ParticipantId& sender, const Buffer&) {
    if (sender == writers_.back()->participant()) ++received;
  });
  ASSERT_TRUE(test::waitUntil([&] { return writers_.back()->hasReaders(); }));
  writers_.back()->write(4, [](std::span<std::byte> place) { std::ranges::fill(place, std::byte{}); });
  EXPECT_TRUE(test::waitUntil([&] { return received == 1; }));
  EXPECT_TRUE(test::waitUntil([&] {
    other.watchTraffic(std::chrono::milliseconds(300));
    const TopicInfo info = other.directory().topic(last);
    return info.publishers.size() == 1 && info.publishers[0].traffic && info.publishers[0].traffic->messages == 7;
  }));
  other.end(std::move(reader));
  many_.reportTraffic({});
}

TEST_F(ManyEndpoints, LeaveRoomForOthersWhenTheyEnd) {
  const ParticipantId first = writers_.front()->participant();
  many_.end(std::move(writers_.front()));
  writers_.front() = many_.makeWriter(topic(0), kType, nullptr);
  EXPECT_EQ(writers_.front()->participant(), first);
}

TEST_F(ManyEndpoints, LetThoseThatBelongTogetherHaveOneParticipant) {
  auto reader = many_.makeReader(
      "/r", kType, [](const ParticipantId&, const Buffer&) {}, {}, writers_.front()->participant());
  EXPECT_EQ(reader->participant(), writers_.front()->participant());
  many_.end(std::move(reader));
}

}  // namespace pongsim::transport
