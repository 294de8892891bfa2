#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pongsim::cli {

/// Size of a character in dots.
inline constexpr std::size_t kLetterWidth = 5;
inline constexpr std::size_t kLetterHeight = 7;

/// The five columns of a character, from the left; the lowest bit is the top dot.
using SmallLetter = std::array<std::uint8_t, kLetterWidth>;

/// @return The bitmap of a printable ASCII character, in the style of dot-matrix displays; others get a box.
SmallLetter smallLetter(char32_t letter);

}  // namespace pongsim::cli
