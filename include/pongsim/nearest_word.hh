#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pongsim/export.hh"

namespace pongsim {

/// @return The one of `known` that is spelt most like `word` (optimal string alignment distance, letter case
/// counting for little), or an empty text if none is near enough to be meant: more than a third of the letters off.
PONGSIM_API std::string_view nearestWord(std::string_view word, std::span<const std::string_view> known);

/// @return "did you mean 'X'?" for the nearest word, or an empty text: the hint of a diagnostic.
PONGSIM_API std::string didYouMean(std::string_view word, std::span<const std::string_view> known);

}  // namespace pongsim
