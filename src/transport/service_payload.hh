#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "transport/inbox.hh"

namespace pongsim::transport {

/// What stands before a request's message. All readers of the service's topics get it; one is meant.
struct RequestHeader {
  ParticipantId server{};
  /// Counts the client's calls.
  std::uint64_t call = 0;
};

/// What stands before a reply's message.
struct ReplyHeader {
  ParticipantId client{};
  std::uint64_t call = 0;
  bool done = false;
  std::string reason;
};

std::size_t headerSize(const RequestHeader& header);
std::size_t headerSize(const ReplyHeader& header);

/// Writes the header to the beginning of `payload`.
/// @return The rest, where the message belongs.
std::span<std::byte> writeHeader(const RequestHeader& header, std::span<std::byte> payload);
std::span<std::byte> writeHeader(const ReplyHeader& header, std::span<std::byte> payload);

/// Reads a header and takes it off `payload`, so that the message remains.
/// @return Nothing where there is none.
std::optional<RequestHeader> readRequestHeader(std::span<const std::byte>& payload);
std::optional<ReplyHeader> readReplyHeader(std::span<const std::byte>& payload);

}  // namespace pongsim::transport
