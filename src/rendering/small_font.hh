#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pongsim::rendering {

/// Size of a character in dots.
inline constexpr std::size_t kLetterWidth = 5;
inline constexpr std::size_t kLetterHeight = 7;
/// From one character to the next.
inline constexpr std::size_t kLetterAdvance = kLetterWidth + 1;

/// The five columns of a character, from the left; the lowest bit is the top dot.
using SmallLetter = std::array<std::uint8_t, kLetterWidth>;

/// @return The bitmap of a printable ASCII character, in the style of dot-matrix displays; others get a box.
SmallLetter smallLetter(char32_t letter);

/// @param text In UTF-8.
/// @return One byte for each character: all beyond ASCII look alike.
std::string lettersOf(std::string_view text);

}  // namespace pongsim::rendering
