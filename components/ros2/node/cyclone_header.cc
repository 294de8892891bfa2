#include "ros2/node/cyclone_header.hh"

#include <algorithm>

#include "ros2/types/cdr.hh"

namespace pongsim::ros2 {

std::optional<CyclonePayload> splitCyclonePayload(std::span<const std::byte> payload) {
  if (payload.size() < kEncapsulation + kCycloneHeader) return std::nullopt;
  const auto encapsulation = payload.first(kEncapsulation);
  const auto header = payload.subspan(kEncapsulation, kCycloneHeader);
  const auto rest = payload.subspan(kEncapsulation + kCycloneHeader);
  CyclonePayload split{{header.begin(), header.end()}, {encapsulation.begin(), encapsulation.end()}};
  const bool isBigEndian = (encapsulation[1] & std::byte(1)) == std::byte(0);
  for (std::size_t i = 0; isBigEndian && i < kCycloneHeader; i += 8) {
    std::reverse(split.header.begin() + static_cast<std::ptrdiff_t>(i),
                 split.header.begin() + static_cast<std::ptrdiff_t>(i) + 8);
  }
  split.message.insert(split.message.end(), rest.begin(), rest.end());
  return split;
}

std::vector<std::byte> cyclonePayload(std::span<const std::byte> header, std::span<const std::byte> message) {
  std::vector<std::byte> payload(message.begin(), message.begin() + kEncapsulation);
  payload.insert(payload.end(), header.begin(), header.end());
  payload.insert(payload.end(), message.begin() + kEncapsulation, message.end());
  return payload;
}

}  // namespace pongsim::ros2
