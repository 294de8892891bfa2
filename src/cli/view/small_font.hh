#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pongsim::cli {

/// Of a letter, in dots.
inline constexpr std::size_t kLetterWidth = 5;
inline constexpr std::size_t kLetterHeight = 7;

/// The five columns of a letter, from the left; the lowest bit is the dot at the top.
using SmallLetter = std::array<std::uint8_t, kLetterWidth>;

/// @return How a printable ASCII character looks, as on the displays of machines; a frame stands for all others.
SmallLetter smallLetter(char32_t letter);

}  // namespace pongsim::cli
