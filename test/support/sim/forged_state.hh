#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace pongsim::test {

/// A saved state's first bytes: its mark, a number made of who is in the world, and a checksum of the rest.
inline constexpr std::size_t kStateHeader = 24;

/// @return The state with a checksum that is right: FNV-1a.
inline std::vector<std::byte> withChecksum(std::vector<std::byte> state) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (std::size_t i = kStateHeader; i < state.size(); ++i) {
    hash = (hash ^ static_cast<std::uint64_t>(state[i])) * 0x100000001b3ULL;
  }
  std::memcpy(state.data() + kStateHeader - sizeof hash, &hash, sizeof hash);
  return state;
}

/// @return The state with some bytes changed, numbers replaced by special ones, cut, or lengthened.
inline std::vector<std::byte> forged(std::vector<std::byte> state, std::mt19937_64& random) {
  const auto below = [&random](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  const std::size_t place = kStateHeader + below(state.size() - kStateHeader - 8);
  // as IEEE 754 doubles: NaN, infinity, 1e308, and 1
  constexpr std::uint64_t kSpecial[] = {0,       ~std::uint64_t{0},       7,
                                        1000000, std::uint64_t{1} << 40U, std::uint64_t{1} << 63U,
                                        1,       0x7ff8000000000000ULL,   0x7ff0000000000000ULL,
                                        5,       0x7fe1ccf385ebc8a0ULL,   0x3ff0000000000000ULL};
  switch (below(5)) {
    case 0:
      state.resize(place);
      break;
    case 1:
    case 2:
      for (std::size_t i = 1 + below(3); i > 0; --i) {
        state[kStateHeader + below(state.size() - kStateHeader)] = static_cast<std::byte>(below(256));
      }
      break;
    case 3:
      std::memcpy(state.data() + place, &kSpecial[below(std::size(kSpecial))], 8);
      break;
    default:
      state.insert(state.begin() + static_cast<std::ptrdiff_t>(place), 1 + below(15),
                   static_cast<std::byte>(below(256)));
  }
  return withChecksum(std::move(state));
}

}  // namespace pongsim::test
