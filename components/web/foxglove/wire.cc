#include "web/foxglove/wire.hh"

#include <utility>

namespace pongsim::web::foxglove {

namespace {

constexpr std::uint8_t kData = 1;
constexpr std::uint8_t kTime = 2;
constexpr std::uint8_t kReply = 3;
constexpr std::uint8_t kAsset = 4;
constexpr std::uint8_t kClientData = 1;
constexpr std::uint8_t kServiceCall = 2;

template <class Number>
void put(Number number, std::string& bytes) {
  for (std::size_t i = 0; i < sizeof number; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

/// Removes a number from the front; nothing if there are too few bytes.
std::optional<std::uint32_t> takeNumber(std::span<const std::byte>& bytes) {
  if (bytes.size() < sizeof(std::uint32_t)) return std::nullopt;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) number |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
  bytes = bytes.subspan(sizeof number);
  return number;
}

}  // namespace

std::string dataHead(std::uint32_t subscription, std::uint64_t timeNs) {
  std::string bytes(1, static_cast<char>(kData));
  put(subscription, bytes);
  put(timeNs, bytes);
  return bytes;
}

Frame timeFrame(std::uint64_t timeNs) {
  std::string bytes(1, static_cast<char>(kTime));
  put(timeNs, bytes);
  return {std::move(bytes), {}};
}

Frame replyFrame(std::uint32_t service, std::uint32_t call, std::string_view encoding, Payload reply) {
  std::string bytes(1, static_cast<char>(kReply));
  put(service, bytes);
  put(call, bytes);
  put(static_cast<std::uint32_t>(encoding.size()), bytes);
  bytes += encoding;
  return {std::move(bytes), std::move(reply)};
}

Frame assetFrame(std::uint32_t request, const Asset& asset) {
  std::string bytes(1, static_cast<char>(kAsset));
  put(request, bytes);
  bytes += asset.error.empty() ? '\0' : '\1';
  put(static_cast<std::uint32_t>(asset.error.size()), bytes);
  bytes += asset.error;
  return {std::move(bytes), asset.error.empty() ? Payload(asset.bytes) : Payload()};
}

std::variant<ClientData, ServiceCall, std::string> readBinary(std::span<const std::byte> message) {
  if (message.empty()) return "a binary message is empty";
  const auto kind = std::to_integer<std::uint8_t>(message.front());
  message = message.subspan(1);
  if (kind == kClientData) {
    const auto channel = takeNumber(message);
    if (!channel) return "a message on a channel is too short";
    return ClientData{*channel, message};
  }
  if (kind != kServiceCall) return "there are no binary messages of kind " + std::to_string(kind);
  const auto service = takeNumber(message);
  const auto call = takeNumber(message);
  const auto length = takeNumber(message);
  if (!length || *length > message.size()) return "a call of a service is too short";
  const std::string_view encoding(reinterpret_cast<const char*>(message.data()), *length);
  return ServiceCall{*service, *call, encoding, message.subspan(*length)};
}

}  // namespace pongsim::web::foxglove
