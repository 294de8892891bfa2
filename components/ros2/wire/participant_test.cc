#include "ros2/wire/participant.hh"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "ros2/wire/local_sockets.hh"
#include "shared/rtps/leases.hh"
#include "support/process.hh"
#include "support/rtps/announced.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

using namespace test;

bool comesTrue(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + test::kDeadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Whoever is killed is forgotten when its lease ends, and whoever lives is not.
/// @param isPaused Whether one is also paused and comes back. In a secured domain it does so only if it has forgotten
/// the others, too, for those who know each other don't authenticate again.
void forgetsTheKilled(bool isPaused) {
  const int domain = test::testDomain();
  Participant participant({.domain = domain});
  std::vector<std::unique_ptr<Process>> others;
  // each simulation has one clock in ROS; its own participant may be in this domain, too, and be met
  const auto clocks = [&] {
    std::vector<Guid> ids;
    for (const Graph::Endpoint& each : participant.graph().endpoints()) {
      if (each.role == Graph::Role::kWriter && each.contract.topic == "rt/clock") ids.push_back(each.id);
    }
    return ids;
  };
  const auto knows = [&](std::size_t count) { return comesTrue([&] { return clocks().size() == count; }); };
  const Process::Options options{.environment = {{"ROS_DOMAIN_ID", std::to_string(domain)}}, .folder = {}};
  std::vector<Guid> living;
  for (std::size_t i = 1; i <= 3; ++i) {
    const std::vector<Guid> before = clocks();
    others.push_back(std::make_unique<Process>(std::vector<std::string>{PONGSIM_PROGRAM, "run", "--ros2"}, options));
    ASSERT_TRUE(knows(i));
    living = clocks();
    std::erase_if(living, [&](const Guid& each) { return std::ranges::count(before, each) > 0; });
  }
  for (int i = 0; i < 2; ++i) {
    others[i]->kill(SIGKILL);
    others[i]->wait();
  }
  EXPECT_TRUE(knows(1));
  EXPECT_EQ(clocks(), living);
  if (isPaused) {
    others[2]->kill(SIGSTOP);
    EXPECT_TRUE(knows(0));
    others[2]->kill(SIGCONT);
    EXPECT_TRUE(knows(1)) << "it is back";
  }
  others[2]->kill(SIGINT);
  EXPECT_TRUE(knows(0)) << "it has said goodbye";
}

/// Somebody who speaks RTPS to all participants that this machine may have in a domain.
class Voice {
 public:
  explicit Voice(int domain) : domain_(domain) {}

  void say(const std::vector<unsigned char>& message) {
    constexpr int kPorts = 7410, kOfDomain = 250, kSought = 120;
    for (int i = 0; i < kSought; ++i) {
      sockaddr_in to{};
      to.sin_family = AF_INET;
      to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      to.sin_port = htons(static_cast<std::uint16_t>(kPorts + kOfDomain * domain_ + 2 * i));
      sendto(socket_.handle(), message.data(), message.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    }
  }

 private:
  int domain_;
  UdpSocket socket_ = openSender();
};

bool doesKnow(const Participant& participant, const shared::RtpsPrefix& prefix) {
  const std::vector<Guid> all = participant.graph().participants();
  return std::ranges::any_of(
      all, [&](const Guid& each) { return std::equal(prefix.begin(), prefix.end(), each.bytes.begin()); });
}

constexpr shared::RtpsPrefix kCyclone = {1, 16, 7}, kCyclonesOther = {1, 16, 8}, kBrief = {1, 15, 9};

TEST(Participant, MeetsTwoParticipantsThatAreAnnouncedInOneMessage) {
  const int domain = test::testDomain();
  Participant participant({.domain = domain});
  Voice voice(domain);
  hostile::Packet both(kCyclone);
  addAnnouncement(both, {.participant = kCyclone, .lease = 1000});
  addSource(both, kCyclonesOther);
  addAnnouncement(both, {.participant = kCyclonesOther, .lease = 1000});
  const auto say = [&] { voice.say(bytesOf(both)); };
  EXPECT_TRUE(comesTrue([&] {
    say();
    return doesKnow(participant, kCyclone) && doesKnow(participant, kCyclonesOther);
  }));
  // Fast DDS alone would make nothing of such a goodbye
  EXPECT_TRUE(comesTrue([&] {
    voice.say(goodbyeOf(kCyclone, Goodbye::kWithKey));
    return !doesKnow(participant, kCyclone);
  }));
  EXPECT_TRUE(doesKnow(participant, kCyclonesOther));
}

TEST(Participant, MeetsNoParticipantOfPongsimsOwnTopics) {
  const int domain = test::testDomain();
  Participant participant({.domain = domain});
  const std::string number = std::to_string(domain);
  const Process::Options options{.environment = {{"ROS_DOMAIN_ID", number}, {"PONGSIM_DOMAIN", number}}, .folder = {}};
  Process simulation({PONGSIM_PROGRAM, "run", "--ros2"}, options);
  ASSERT_TRUE(comesTrue([&] { return !participant.graph().endpointsOn("rt/clock", Graph::Role::kWriter).empty(); }));
  // its own topics are there, too
  ASSERT_TRUE(comesTrue([&] {
    Process list({PONGSIM_PROGRAM, "topic", "-l"}, options);
    return list.wait() == 0 && list.output().find("/clock") != std::string::npos;
  }));
  EXPECT_EQ(participant.graph().participants().size(), 1U);
}

TEST(Participant, OutlivesGoodbyesAtTheEndsOfLeases) {
  const int domain = test::testDomain();
  Participant participant({.domain = domain});
  Voice voice(domain);
  ASSERT_TRUE(comesTrue([&] {
    voice.say(announcementOf({.participant = kBrief, .lease = 1}));
    return doesKnow(participant, kBrief);
  }));
  EXPECT_TRUE(comesTrue([&] { return !doesKnow(participant, kBrief); })) << "it is silent";
  ASSERT_TRUE(comesTrue([&] {
    voice.say(announcementOf({.participant = kBrief, .lease = 1}));
    return doesKnow(participant, kBrief);
  })) << "and comes back with an announcement that is no newer";

  using Clock = std::chrono::steady_clock;
  constexpr int kMany = 400;
  std::vector<std::pair<shared::RtpsPrefix, Clock::time_point>> others;
  for (int i = 0; i < kMany; ++i) {
    const shared::RtpsPrefix prefix = {1, 15, 1, static_cast<unsigned char>(i >> 8), static_cast<unsigned char>(i)};
    voice.say(announcementOf({.participant = prefix, .lease = 1}));
    // about when its end is noticed
    others.emplace_back(prefix, Clock::now() + std::chrono::microseconds(1'000'000 + i % 40 * 100));
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  std::ranges::sort(others, {}, [](const auto& each) { return each.second; });
  for (const auto& [prefix, end] : others) {
    std::this_thread::sleep_until(end);
    voice.say(goodbyeOf(prefix));
  }
  EXPECT_TRUE(comesTrue([&] { return participant.graph().participants().empty(); }));
}

TEST(Participant, ForgetsWhoWasKilled) { forgetsTheKilled(true); }

TEST(Participant, ForgetsWhoWasKilledOfASecuredDomain) {
  const test::TempFolder folder;
  const std::string keys = folder.path() / "keys";
  Process security({PONGSIM_PROGRAM, "security", "init", keys});
  ASSERT_EQ(security.wait(), 0) << security.error();
  setenv("PONGSIM_SECURITY", keys.c_str(), 1);
  forgetsTheKilled(false);
  unsetenv("PONGSIM_SECURITY");
}

}  // namespace
}  // namespace pongsim::ros2
