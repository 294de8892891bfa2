#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pongsim/export.hh"

namespace pongsim {

/// @return The word of `known` most similar to `word` (optimal string alignment distance; letter case counts little),
/// or an empty text if more than a third of the letters differ.
PONGSIM_API std::string_view nearestWord(std::string_view word, std::span<const std::string_view> known);

/// @return "did you mean 'X'?" for the nearest word, or an empty text: the hint of a diagnostic.
PONGSIM_API std::string didYouMean(std::string_view word, std::span<const std::string_view> known);

}  // namespace pongsim
