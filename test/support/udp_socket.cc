#include "support/udp_socket.hh"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>

#include "support/process.hh"

namespace pongsim::test {

UdpSocket::UdpSocket(std::uint32_t address, std::uint32_t port) : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(address);
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (descriptor_ >= 0 && bind(descriptor_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) return;
  const int error = errno;
  if (descriptor_ >= 0) close(descriptor_);
  throw std::system_error(error, std::generic_category(), "UDP port " + std::to_string(port));
}

UdpSocket::~UdpSocket() { close(descriptor_); }

std::string UdpSocket::hearBeginning() {
  pollfd waited{descriptor_, POLLIN, 0};
  std::array<char, 4> bytes{};
  constexpr auto kMilliseconds = static_cast<int>(std::chrono::milliseconds(kDeadline).count());
  if (poll(&waited, 1, kMilliseconds) != 1 || recv(descriptor_, bytes.data(), bytes.size(), 0) != 4) return {};
  return {bytes.begin(), bytes.end()};
}

}  // namespace pongsim::test
