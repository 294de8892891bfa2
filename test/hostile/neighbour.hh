#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "hostile/packet.hh"

namespace pongsim::hostile {

/// Highest number of participants of a domain on one machine.
inline constexpr int kMostParticipants = 115;

/// @return The port where the participant with this number listens for announcements (RTPS 2.3, 9.6.1.1).
std::uint16_t discoveryPort(int domain, int number);

/// A participant of the domain, as it announces itself.
struct Neighbour {
  Prefix prefix{};
  /// Ports on 127.0.0.1 for announcements and for messages.
  std::uint16_t discoveryPort = 0;
  std::uint16_t userPort = 0;
};

/// The attacker's socket: on 127.0.0.1, at one of the domain's discovery ports, so that other participants announce
/// themselves to it. Messages of all attacks but `kSockets` are sent from it.
class Foothold {
 public:
  /// @throws std::runtime_error if the domain has no free port.
  explicit Foothold(int domain);
  ~Foothold();
  Foothold(const Foothold&) = delete;
  Foothold& operator=(const Foothold&) = delete;

  std::uint16_t port() const { return port_; }

  /// Listens for `duration`, and then on until a participant has been heard or `atMost` is over.
  std::vector<Neighbour> hear(std::chrono::milliseconds duration, std::chrono::milliseconds atMost);

  /// Sends to 127.0.0.1. If the receiver's buffer is full, the packet is lost.
  void send(std::span<const std::uint8_t> bytes, std::uint16_t port) const;

 private:
  int descriptor_ = -1;
  std::uint16_t port_ = 0;
};

/// Sends to 127.0.0.1 from a new socket, and closes it.
void sendFromNewSocket(std::span<const std::uint8_t> bytes, std::uint16_t port);

}  // namespace pongsim::hostile
