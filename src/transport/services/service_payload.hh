#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "transport/inbox.hh"

namespace pongsim::transport {

/// Precedes a request's message. All readers of the service's topics receive it; it is for one of them.
struct RequestHeader {
  ParticipantId server{};
  /// Number of the client's call.
  std::uint64_t call = 0;
};

/// Precedes a reply's message.
struct ReplyHeader {
  ParticipantId client{};
  std::uint64_t call = 0;
  bool done = false;
  std::string reason;
};

std::size_t headerSize(const RequestHeader& header);
std::size_t headerSize(const ReplyHeader& header);

/// Writes the header to the beginning of `payload`.
/// @return The rest, for the message.
std::span<std::byte> writeHeader(const RequestHeader& header, std::span<std::byte> payload);
std::span<std::byte> writeHeader(const ReplyHeader& header, std::span<std::byte> payload);

/// Reads a header and removes it from `payload`, so that the message remains.
/// @return Nothing if there is none.
std::optional<RequestHeader> readRequestHeader(std::span<const std::byte>& payload);
std::optional<ReplyHeader> readReplyHeader(std::span<const std::byte>& payload);

}  // namespace pongsim::transport
