#include "transport/network/traffic_report.hh"

#include <algorithm>
#include <string_view>
#include <utility>

#include "shared/rtps/wire_number.hh"

namespace pongsim::transport {

namespace {

using shared::putNumber;
using shared::takeNumber;

constexpr std::size_t kTimeSize = 8, kRoleSize = 1, kNameLengthSize = 2, kCountSize = 8;
constexpr std::size_t kLongestName = 65'535;

std::string_view clipped(const std::string& name) { return std::string_view(name).substr(0, kLongestName); }

std::size_t sizeOf(const EndpointTraffic& endpoint) {
  return kRoleSize + 2 * kNameLengthSize + clipped(endpoint.topic).size() + clipped(endpoint.type).size() +
         2 * kCountSize;
}

void putName(std::string_view name, std::span<std::byte>& place) {
  putNumber(name.size(), kNameLengthSize, place);
  std::ranges::copy(std::as_bytes(std::span(name)), place.begin());
  place = place.subspan(name.size());
}

std::optional<std::string> takeName(std::span<const std::byte>& bytes) {
  if (bytes.size() < kNameLengthSize) return std::nullopt;
  const std::uint64_t length = takeNumber(kNameLengthSize, bytes);
  if (bytes.size() < length) return std::nullopt;
  std::string name(reinterpret_cast<const char*>(bytes.data()), length);
  bytes = bytes.subspan(length);
  return name;
}

std::optional<EndpointTraffic> takeEndpoint(std::span<const std::byte>& bytes) {
  const std::uint64_t role = takeNumber(kRoleSize, bytes);
  std::optional<std::string> topic = takeName(bytes);
  std::optional<std::string> type = topic ? takeName(bytes) : std::nullopt;
  if (role > 1 || !type || bytes.size() < 2 * kCountSize) return std::nullopt;
  EndpointTraffic endpoint;
  endpoint.role = role == 0 ? Role::kPublisher : Role::kSubscriber;
  endpoint.topic = *std::move(topic);
  endpoint.type = *std::move(type);
  endpoint.messages = takeNumber(kCountSize, bytes);
  endpoint.dropped = takeNumber(kCountSize, bytes);
  return endpoint;
}

}  // namespace

std::vector<std::byte> trafficBytes(const TrafficReport& report) {
  std::size_t size = kTimeSize;
  for (const EndpointTraffic& endpoint : report.endpoints) size += sizeOf(endpoint);
  std::vector<std::byte> bytes(size);
  std::span<std::byte> place = bytes;
  putNumber(static_cast<std::uint64_t>(report.at.count()), kTimeSize, place);
  for (const EndpointTraffic& endpoint : report.endpoints) {
    putNumber(endpoint.role == Role::kPublisher ? 0 : 1, kRoleSize, place);
    putName(clipped(endpoint.topic), place);
    putName(clipped(endpoint.type), place);
    putNumber(endpoint.messages, kCountSize, place);
    putNumber(endpoint.dropped, kCountSize, place);
  }
  return bytes;
}

std::optional<TrafficReport> readTraffic(std::span<const std::byte> bytes) {
  if (bytes.size() < kTimeSize) return std::nullopt;
  TrafficReport report;
  report.at = std::chrono::nanoseconds(static_cast<std::int64_t>(takeNumber(kTimeSize, bytes)));
  while (!bytes.empty()) {
    std::optional<EndpointTraffic> endpoint = takeEndpoint(bytes);
    if (!endpoint) return std::nullopt;
    report.endpoints.push_back(*std::move(endpoint));
  }
  return report;
}

}  // namespace pongsim::transport
