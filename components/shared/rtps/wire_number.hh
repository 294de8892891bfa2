#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pongsim::shared {

/// @param bytes At most 8, of std::byte or std::uint8_t.
/// @return The unsigned number that they encode.
template <class Byte>
std::uint64_t readNumber(std::span<const Byte> bytes, bool isLittleEndian = true) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    number = number << 8 | static_cast<std::uint64_t>(bytes[isLittleEndian ? bytes.size() - 1 - i : i]);
  }
  return number;
}

/// Writes the lowest bytes of a number, one for each byte of `place`, at most 8.
template <class Byte>
void writeNumber(std::uint64_t number, std::span<Byte> place, bool isLittleEndian = true) {
  for (std::size_t i = 0; i < place.size(); ++i) {
    place[isLittleEndian ? i : place.size() - 1 - i] = static_cast<Byte>(number >> (8 * i));
  }
}

/// Writes an unsigned number of `size` bytes, least significant first, to the beginning of `place`, and removes them
/// from it. There must be room.
inline void putNumber(std::uint64_t number, std::size_t size, std::span<std::byte>& place) {
  writeNumber(number, place.first(size));
  place = place.subspan(size);
}

/// Reads such a number from the beginning of `bytes`, which must have as many, and removes it.
inline std::uint64_t takeNumber(std::size_t size, std::span<const std::byte>& bytes) {
  const std::uint64_t number = readNumber(bytes.first(size));
  bytes = bytes.subspan(size);
  return number;
}

}  // namespace pongsim::shared
