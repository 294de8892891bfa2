#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pongsim::ros2 {

/// The receive buffer of a UDP socket, in bytes as the kernel counts them, which includes its own administration.
struct ReceiveBuffer {
  std::size_t size = 0;
  std::size_t used = 0;
};

/// @param address An address of this machine, in network order.
/// @return The buffer of the socket that receives what is sent there; nothing if the kernel does not tell.
std::optional<ReceiveBuffer> receiveBufferOf(std::uint32_t address, std::uint16_t port);

/// The same as `/proc/net/udp` tells it, for any address: the use of the fullest socket at this port, and the default
/// size.
std::optional<ReceiveBuffer> receiveBufferByProc(std::uint16_t port);

}  // namespace pongsim::ros2
