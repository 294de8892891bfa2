#include "ign/heartbeats.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "ign/library.hh"
#include "support/ign/discovery_packet.hh"
#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

void say(const std::string& packet) { EXPECT_TRUE(sayToGroup(packet, library().discoveryIP, library().msgDiscPort)); }

std::string beatOf(const std::string& process) { return packetOf(process, ignition::msgs::Discovery::HEARTBEAT); }

TEST(Heartbeats, TellsOfTheLivingAndTakesNoGarbage) {
  setenv("IGN_IP", "127.0.0.1", 1);
  Heartbeats heartbeats("127.0.0.1");
  // a process without any heartbeat counts as alive
  EXPECT_TRUE(heartbeats.isAlive("somebody"));
  for (const char* garbage : {"", "x", "xy", "\x02\x01garbage"}) say(garbage);
  say(std::string("\x05\0", 2) + "\xff\xff\xff\xff\xff");
  say(beatOf("somebody"));
  // a busy machine may delay multicast packets
  EXPECT_TRUE(test::waitUntil([&] {
    heartbeats.read();
    return !heartbeats.isAlive("somebody", Heartbeats::Clock::now() + std::chrono::seconds(11));
  }));
  const Heartbeats::Clock::time_point now = Heartbeats::Clock::now();
  EXPECT_TRUE(heartbeats.isAlive("somebody", now));
  say(beatOf("somebody"));
  heartbeats.read();
  EXPECT_TRUE(heartbeats.isAlive("somebody", now + std::chrono::seconds(9)));
}

}  // namespace
}  // namespace pongsim::ign
