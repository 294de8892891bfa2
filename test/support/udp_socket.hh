#pragma once

#include <cstdint>
#include <string>

namespace pongsim::test {

/// A bound UDP socket, closed when it is destroyed.
class UdpSocket {
 public:
  /// @param address In the host's byte order, as INADDR_LOOPBACK.
  /// @param port 0: any that is free.
  /// @throws std::system_error where it can't be had.
  UdpSocket(std::uint32_t address, std::uint32_t port);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  /// @return The first four bytes of the next packet, or nothing after `kDeadline` or where it has not as many.
  std::string hearBeginning();

 private:
  int descriptor_;
};

}  // namespace pongsim::test
