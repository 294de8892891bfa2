#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pongsim::base {

inline constexpr std::string_view kWhiteSpace = " \t\r\n\f\v";

/// @return The text without the characters of `space` at its ends.
std::string_view trimmed(std::string_view text, std::string_view space = kWhiteSpace);

/// @return "one, two, three".
std::string listed(std::span<const std::string_view> words);

}  // namespace pongsim::base
