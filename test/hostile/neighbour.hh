#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "hostile/packet.hh"

namespace pongsim::hostile {

/// So many participants a domain has room for on one machine.
inline constexpr int kMostParticipants = 115;

/// @return Where the participant of that number listens for others (RTPS 2.3, 9.6.1.1).
std::uint16_t discoveryPort(int domain, int number);

/// A participant of the domain, as it tells of itself.
struct Neighbour {
  Prefix prefix{};
  /// Ports on 127.0.0.1 where it hears of others, and where it takes messages.
  std::uint16_t discoveryPort = 0;
  std::uint16_t userPort = 0;
};

/// The attacker's own place in a domain: a socket of 127.0.0.1 at one of the domain's discovery ports, where the others
/// announce themselves. All attacks leave from it, but for those that say otherwise.
class Foothold {
 public:
  /// @throws std::runtime_error where the domain has no port left.
  explicit Foothold(int domain);
  ~Foothold();
  Foothold(const Foothold&) = delete;
  Foothold& operator=(const Foothold&) = delete;

  std::uint16_t port() const { return port_; }

  /// Listens for that long, and at least until somebody has been heard or `atMost` is over.
  std::vector<Neighbour> hear(std::chrono::milliseconds duration, std::chrono::milliseconds atMost);

  /// Sends to 127.0.0.1. What has no room is lost, as on any wire.
  void send(std::span<const std::uint8_t> bytes, std::uint16_t port) const;

 private:
  int descriptor_ = -1;
  std::uint16_t port_ = 0;
};

/// Sends to 127.0.0.1 from a socket that nobody has heard before, and closes it.
void sendFromNewSocket(std::span<const std::uint8_t> bytes, std::uint16_t port);

}  // namespace pongsim::hostile
