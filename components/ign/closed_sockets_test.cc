#include "ign/closed_sockets.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

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
  const int before = closeDiscoveryToOthers();
  EXPECT_GE(before, 2);
  Heartbeats heartbeats("127.0.0.1");
  EXPECT_EQ(closeDiscoveryToOthers(), before + 1);
  const std::string beat = packetOf("neighbour", ignition::msgs::Discovery::HEARTBEAT);
  EXPECT_TRUE(sayToGroup(beat, library().discoveryIP, library().msgDiscPort));
  // a process that sends no heartbeat would also count as alive at first
  EXPECT_TRUE(test::waitUntil([&] {
    heartbeats.read();
    return !heartbeats.isAlive("neighbour", Heartbeats::Clock::now() + std::chrono::seconds(11));
  }));
  EXPECT_TRUE(heartbeats.isAlive("neighbour"));
}

}  // namespace
}  // namespace pongsim::ign
