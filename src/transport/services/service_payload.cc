#include "transport/services/service_payload.hh"

#include <algorithm>

#include "shared/rtps/wire_number.hh"

namespace pongsim::transport {

namespace {

using shared::putNumber;
using shared::takeNumber;

constexpr std::size_t kIdSize = std::tuple_size_v<ParticipantId>;
constexpr std::size_t kCallSize = 8, kDoneSize = 1, kLengthSize = 4;
constexpr std::size_t kRequestSize = kIdSize + kCallSize;
constexpr std::size_t kReplySize = kIdSize + kCallSize + kDoneSize + kLengthSize;

void putId(const ParticipantId& id, std::span<std::byte>& place) {
  std::ranges::transform(id, place.begin(), [](std::uint8_t byte) { return std::byte{byte}; });
  place = place.subspan(kIdSize);
}

ParticipantId takeId(std::span<const std::byte>& bytes) {
  ParticipantId id{};
  std::ranges::transform(bytes.first(kIdSize), id.begin(),
                         [](std::byte byte) { return std::to_integer<uint8_t>(byte); });
  bytes = bytes.subspan(kIdSize);
  return id;
}

}  // namespace

std::size_t headerSize(const RequestHeader&) { return kRequestSize; }

std::size_t headerSize(const ReplyHeader& header) { return kReplySize + header.reason.size(); }

std::span<std::byte> writeHeader(const RequestHeader& header, std::span<std::byte> payload) {
  putId(header.server, payload);
  putNumber(header.call, kCallSize, payload);
  return payload;
}

std::span<std::byte> writeHeader(const ReplyHeader& header, std::span<std::byte> payload) {
  putId(header.client, payload);
  putNumber(header.call, kCallSize, payload);
  putNumber(header.done ? 1 : 0, kDoneSize, payload);
  putNumber(header.reason.size(), kLengthSize, payload);
  std::ranges::copy(std::as_bytes(std::span(header.reason)), payload.begin());
  return payload.subspan(header.reason.size());
}

std::optional<RequestHeader> readRequestHeader(std::span<const std::byte>& payload) {
  if (payload.size() < kRequestSize) return std::nullopt;
  RequestHeader header;
  header.server = takeId(payload);
  header.call = takeNumber(kCallSize, payload);
  return header;
}

std::optional<ReplyHeader> readReplyHeader(std::span<const std::byte>& payload) {
  if (payload.size() < kReplySize) return std::nullopt;
  std::span<const std::byte> rest = payload;
  ReplyHeader header;
  header.client = takeId(rest);
  header.call = takeNumber(kCallSize, rest);
  const std::uint64_t done = takeNumber(kDoneSize, rest);
  const std::uint64_t length = takeNumber(kLengthSize, rest);
  if (done > 1 || length > rest.size()) return std::nullopt;
  header.done = done == 1;
  header.reason.assign(reinterpret_cast<const char*>(rest.data()), length);
  payload = rest.subspan(length);
  return header;
}

}  // namespace pongsim::transport
