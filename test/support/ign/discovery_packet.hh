#pragma once

#include <arpa/inet.h>
#include <ignition/msgs/discovery.pb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

namespace pongsim::ign {

/// Sends a packet on 127.0.0.1 to the discovery group, as other processes do.
/// @return Whether it was sent.
inline bool sayToGroup(const std::string& packet, const std::string& group, int port) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  const in_addr loopback{inet_addr("127.0.0.1")};
  setsockopt(socket, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = inet_addr(group.c_str());
  const ssize_t sent =
      sendto(socket, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  ::close(socket);
  return sent == static_cast<ssize_t>(packet.size());
}

/// @return A discovery packet of a process, preceded by its length.
inline std::string packetOf(const std::string& process, ignition::msgs::Discovery::Type type) {
  ignition::msgs::Discovery message;
  message.set_version(10);
  message.set_process_uuid(process);
  message.set_type(type);
  const std::string body = message.SerializeAsString();
  const auto length = static_cast<std::uint16_t>(body.size());
  std::string packet(sizeof length, '\0');
  std::memcpy(packet.data(), &length, sizeof length);
  return packet + body;
}

/// Hears what processes say on 127.0.0.1 to the discovery group.
class GroupListener {
 public:
  GroupListener(const std::string& group, int port) {
    const int yes = 1;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = inet_addr(group.c_str());
    const ip_mreq membership{address.sin_addr, {inet_addr("127.0.0.1")}};
    setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    setsockopt(socket_, SOL_SOCKET, SO_REUSEPORT, &yes, sizeof yes);
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
      setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership);
    }
  }
  ~GroupListener() { ::close(socket_); }
  GroupListener(const GroupListener&) = delete;
  GroupListener& operator=(const GroupListener&) = delete;

  /// @return The next packet that has arrived; nothing without one.
  std::optional<ignition::msgs::Discovery> next() {
    char packet[65536];
    const ssize_t size = recv(socket_, packet, sizeof packet, MSG_DONTWAIT);
    ignition::msgs::Discovery message;
    if (size < 2 || !message.ParseFromArray(packet + 2, static_cast<int>(size) - 2)) return std::nullopt;
    return message;
  }

 private:
  int socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

}  // namespace pongsim::ign
