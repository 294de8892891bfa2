#include "ign/heartbeats.hh"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <ignition/msgs/discovery.pb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include <ignition/transport/NodeShared.hh>

namespace pongsim::ign {
namespace {

/// Says something to the group of discovery, as other processes do.
void say(const std::string& packet) {
  const auto* shared = ignition::transport::NodeShared::Instance();
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  const in_addr loopback{inet_addr("127.0.0.1")};
  setsockopt(socket, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
  sockaddr_in group{};
  group.sin_family = AF_INET;
  group.sin_port = htons(static_cast<std::uint16_t>(shared->msgDiscPort));
  group.sin_addr.s_addr = inet_addr(shared->discoveryIP.c_str());
  EXPECT_EQ(sendto(socket, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&group), sizeof group),
            static_cast<ssize_t>(packet.size()));
  ::close(socket);
}

std::string beatOf(const std::string& process) {
  ignition::msgs::Discovery message;
  message.set_version(10);
  message.set_process_uuid(process);
  message.set_type(ignition::msgs::Discovery::HEARTBEAT);
  const std::string body = message.SerializeAsString();
  const auto length = static_cast<std::uint16_t>(body.size());
  std::string packet(sizeof length, '\0');
  std::memcpy(packet.data(), &length, sizeof length);
  return packet + body;
}

TEST(Heartbeats, TellsOfTheLivingAndTakesNoGarbage) {
  setenv("IGN_IP", "127.0.0.1", 1);
  Heartbeats heartbeats("127.0.0.1");
  // one that was never heard may have been there before
  EXPECT_TRUE(heartbeats.isAlive("somebody"));
  for (const char* garbage : {"", "x", "xy", "\x02\x01garbage"}) say(garbage);
  say(std::string("\x05\0", 2) + "\xff\xff\xff\xff\xff");
  say(beatOf("somebody"));
  heartbeats.read();
  const Heartbeats::Clock::time_point now = Heartbeats::Clock::now();
  EXPECT_TRUE(heartbeats.isAlive("somebody", now));
  EXPECT_FALSE(heartbeats.isAlive("somebody", now + std::chrono::seconds(11)));
  say(beatOf("somebody"));
  heartbeats.read();
  EXPECT_TRUE(heartbeats.isAlive("somebody", now + std::chrono::seconds(9)));
}

}  // namespace
}  // namespace pongsim::ign
