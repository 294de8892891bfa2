#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pongsim::transport {

/// Writes an unsigned number of `size` bytes, least significant first, to the beginning of `place`, and removes them
/// from it. There must be room.
inline void putNumber(std::uint64_t number, std::size_t size, std::span<std::byte>& place) {
  for (std::size_t i = 0; i < size; ++i) place[i] = static_cast<std::byte>(number >> (8 * i));
  place = place.subspan(size);
}

/// Reads such a number from the beginning of `bytes`, which must have as many, and removes it.
inline std::uint64_t takeNumber(std::size_t size, std::span<const std::byte>& bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
  bytes = bytes.subspan(size);
  return number;
}

}  // namespace pongsim::transport
