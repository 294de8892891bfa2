#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pongsim::ros2 {

/// rmw_cyclonedds relates requests and replies by 16 bytes between the encapsulation and the message: the client's id
/// and the request's number. A reply repeats those of its request.
inline constexpr std::size_t kCycloneHeader = 16;

struct CyclonePayload {
  /// Little endian.
  std::vector<std::byte> header;
  /// CDR with encapsulation, as without the header.
  std::vector<std::byte> message;
};

/// @return Nothing if the payload is too short.
std::optional<CyclonePayload> splitCyclonePayload(std::span<const std::byte> payload);

/// @param message CDR with encapsulation, little endian.
std::vector<std::byte> cyclonePayload(std::span<const std::byte> header, std::span<const std::byte> message);

}  // namespace pongsim::ros2
