#include "ign/heartbeats.hh"

#include <arpa/inet.h>
#include <ignition/msgs/discovery.pb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "ign/library.hh"
#include "ign/subscriber_list.hh"

namespace pongsim::ign {

namespace {

// Time without a heartbeat after which a process counts as ended: ten periods of the library, because a busy machine
// may delay heartbeats.
constexpr std::chrono::seconds kSilence{10};
// Limits for memory and time: anybody can send heartbeats of processes that do not exist.
constexpr std::size_t kMostProcesses = 10'000;
constexpr int kMostAtOnce = 1000;

/// @return A socket that receives packets to the discovery's multicast group on the interface with this address, or -1.
/// It is bound to the group's address, so it takes no unicast packets from the library's socket.
int openGroup(const std::string& address) {
  const auto& shared = library();
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket < 0) return -1;
  const int yes = 1;
  sockaddr_in group{};
  group.sin_family = AF_INET;
  group.sin_port = htons(static_cast<std::uint16_t>(shared.msgDiscPort));
  group.sin_addr.s_addr = inet_addr(shared.discoveryIP.c_str());
  const ip_mreq membership{group.sin_addr, {inet_addr(address.c_str())}};
  const bool isOpen = setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
                      setsockopt(socket, SOL_SOCKET, SO_REUSEPORT, &yes, sizeof yes) == 0 &&
                      bind(socket, reinterpret_cast<const sockaddr*>(&group), sizeof group) == 0 &&
                      setsockopt(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) == 0;
  if (isOpen) return socket;
  ::close(socket);
  return -1;
}

}  // namespace

Heartbeats::Heartbeats(const std::string& address) : socket_(openGroup(address)) {}

Heartbeats::~Heartbeats() {
  if (socket_ >= 0) ::close(socket_);
}

void Heartbeats::read() {
  std::array<char, 65536> packet{};
  for (int i = 0; socket_ >= 0 && i < kMostAtOnce; ++i) {
    const ssize_t size = recv(socket_, packet.data(), packet.size(), 0);
    if (size < 0) return;
    // a packet begins with its length in 2 bytes
    std::uint16_t length = 0;
    if (size < static_cast<ssize_t>(sizeof length)) continue;
    std::memcpy(&length, packet.data(), sizeof length);
    ignition::msgs::Discovery message;
    if (static_cast<std::size_t>(size) != sizeof length + length) continue;
    if (!message.ParseFromArray(packet.data() + sizeof length, length) || message.process_uuid().empty()) continue;
    if (static_cast<int>(message.type()) == SubscriberList::kRequest) isAsked_ = true;
    if (heard_.size() < kMostProcesses || heard_.contains(message.process_uuid())) {
      heard_[message.process_uuid()] = Clock::now();
    }
  }
}

bool Heartbeats::isAlive(const std::string& process, Clock::time_point now) const {
  const auto found = heard_.find(process);
  return found == heard_.end() || now - found->second < kSilence;
}

}  // namespace pongsim::ign
