#pragma once

#include <cstdint>
#include <string>

namespace pongsim::test {

/// A bound UDP socket, closed when it is destroyed.
class UdpSocket {
 public:
  /// @param address In the host's byte order, like INADDR_LOOPBACK.
  /// @param port 0: any free one.
  /// @throws std::system_error if the port is not free.
  UdpSocket(std::uint32_t address, std::uint32_t port);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  /// @return The first four bytes of the next packet; empty after `kDeadline`, or if the packet is shorter.
  std::string hearBeginning();

 private:
  int descriptor_;
};

}  // namespace pongsim::test
