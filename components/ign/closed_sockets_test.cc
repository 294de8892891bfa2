#include "ign/closed_sockets.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <streambuf>
#include <string>

#include "ign/heartbeats.hh"
#include "ign/library.hh"
#include "support/ign/discovery_packet.hh"
#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

TEST(ClosedSockets, AreThoseOfDiscoveryWhichHearThisMachine) {
  setenv("IGN_IP", "127.0.0.1", 1);
  library();
  // one socket for messages, one for services
  const int before = filterDiscovery(false);
  EXPECT_GE(before, 2);
  Heartbeats heartbeats("127.0.0.1");
  EXPECT_EQ(filterDiscovery(false), before + 1);
  const std::string beat = packetOf("neighbour", ignition::msgs::Discovery::HEARTBEAT);
  EXPECT_TRUE(sayToGroup(beat, library().discoveryIP, library().msgDiscPort));
  // a process that sends no heartbeat would also count as alive at first
  EXPECT_TRUE(test::waitUntil([&] {
    heartbeats.read();
    return !heartbeats.isAlive("neighbour", Heartbeats::Clock::now() + std::chrono::seconds(11));
  }));
  EXPECT_TRUE(heartbeats.isAlive("neighbour"));
}

/// What is printed on std::cerr, by any thread.
class Printed final : public std::streambuf {
 public:
  Printed() : before_(std::cerr.rdbuf(this)) {}
  ~Printed() override { std::cerr.rdbuf(before_); }

  std::string text() {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 protected:
  std::streamsize xsputn(const char* characters, std::streamsize count) override {
    const std::lock_guard lock(mutex_);
    text_.append(characters, static_cast<std::size_t>(count));
    return count;
  }
  int overflow(int character) override {
    const char one = static_cast<char>(character);
    xsputn(&one, 1);
    return character;
  }

 private:
  std::mutex mutex_;
  std::string text_;
  std::streambuf* const before_;
};

TEST(ClosedSockets, HearNoKindsOfPacketsThatTheLibraryDoesNotKnow) {
  setenv("IGN_IP", "127.0.0.1", 1);
  library();
  // as a process with default settings, which is told of everything
  EXPECT_GE(filterDiscovery(true), 2);
  Printed printed;
  const auto say = [](const std::string& process, int type) {
    const std::string packet = packetOf(process, static_cast<ignition::msgs::Discovery::Type>(type));
    EXPECT_TRUE(sayToGroup(packet, library().discoveryIP, library().msgDiscPort));
  };
  const std::string other = ignition::transport::Uuid().ToString();
  EXPECT_TRUE(test::waitUntil([&] {
    say(other, 8);
    say(other, 9);
    // passes the filter, since ids have 36 characters
    say("somebody", 12);
    return printed.text().find("Unknown message type [12]") != std::string::npos;
  }));
  EXPECT_EQ(printed.text().find("type [8]"), std::string::npos) << printed.text();
  EXPECT_EQ(printed.text().find("type [9]"), std::string::npos) << printed.text();
}

}  // namespace
}  // namespace pongsim::ign
