#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pongsim::fuzz {

/// Splits bytes into messages and calls `receive(message, isMarked)` for each. A message follows its length in two
/// bytes, little-endian, whose highest bit is the mark. The message is a copy, so that the sanitizer detects reads past
/// its end.
template <class Receive>
void splitMessages(std::span<const std::uint8_t> bytes, const Receive& receive) {
  while (bytes.size() > 2) {
    const bool isMarked = (bytes[1] & 0x80U) != 0;
    const std::size_t length = std::min<std::size_t>(bytes[0] + 256U * (bytes[1] & 0x7fU), bytes.size() - 2);
    const auto content = bytes.subspan(2, length);
    std::vector<std::uint8_t> message(content.begin(), content.end());
    receive(message, isMarked);
    bytes = bytes.subspan(2 + length);
  }
}

}  // namespace pongsim::fuzz
