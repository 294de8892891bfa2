#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/sockets/senders.hh"

namespace pongsim::ros2 {

/// An IPv4 address of this machine.
struct LocalAddress {
  std::string interface;
  /// In the network's byte order, as all addresses here.
  std::uint32_t address = 0;
  bool isLoopback = false;
};

/// @return Those of the interfaces that are up, 127.0.0.1 first.
std::vector<LocalAddress> localAddresses();

std::string textOf(std::uint32_t address);

/// A UDP socket, closed when it ends.
class UdpSocket {
 public:
  explicit UdpSocket(int handle = -1) : handle_(handle) {}
  ~UdpSocket();
  UdpSocket(UdpSocket&& other) noexcept : handle_(other.handle_) { other.handle_ = -1; }
  UdpSocket& operator=(UdpSocket&& other) noexcept;
  explicit operator bool() const { return handle_ >= 0; }
  int handle() const { return handle_; }

 private:
  int handle_;
};

/// @return A socket that receives what is sent to any address of this machine at the port, by `senders`; empty
/// where the port is taken.
UdpSocket openUnicast(std::uint16_t port, const shared::Senders& senders);

/// @return A socket that receives what is sent to the group at the port by way of that interface; others may share
/// the port. Empty where it can't be had.
UdpSocket openMulticast(std::uint32_t group, std::uint16_t port, std::uint32_t interface,
                        const shared::Senders& senders);

/// @return A socket that sends and hears nothing.
UdpSocket openSender();

/// @return One that sends to groups by way of that interface.
/// @param timeToLive 0: to this machine alone.
UdpSocket openGroupSender(std::uint32_t interface, int timeToLive);

}  // namespace pongsim::ros2
