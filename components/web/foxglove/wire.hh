#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "web/server/session.hh"

/// Binary messages of Foxglove's WebSocket protocol. Numbers are little endian.
namespace pongsim::web::foxglove {

/// @return The header of a message for a subscription.
std::string dataHead(std::uint32_t subscription, std::uint64_t timeNs);
Frame timeFrame(std::uint64_t timeNs);
Frame replyFrame(std::uint32_t service, std::uint32_t call, std::string_view encoding, Payload reply);
/// @param asset Its error, if any, is sent; otherwise its bytes.
Frame assetFrame(std::uint32_t request, const Asset& asset);

/// A message on a channel of the client. Valid as long as its bytes; the same for `ServiceCall`.
struct ClientData {
  std::uint32_t channel = 0;
  std::span<const std::byte> message;
};
struct ServiceCall {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string_view encoding;
  std::span<const std::byte> request;
};

/// @return The client's message, or what is wrong with it.
std::variant<ClientData, ServiceCall, std::string> readBinary(std::span<const std::byte> message);

}  // namespace pongsim::web::foxglove
