#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace pongsim::base {

/// FNV-1a with 64 bits (Fowler, Noll, Vo; RFC 9923): gives the same number on every machine.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (unsigned shift = 0; shift < 64; shift += 8) addByte(static_cast<std::uint8_t>(bits >> shift));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    for (char letter : text) addByte(static_cast<std::uint8_t>(letter));
  }

  std::uint64_t value() const { return value_; }

 private:
  void addByte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }

  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace pongsim::base
