#pragma once

#include <optional>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim::sdf {

inline constexpr int kOldestVersion = 4;
inline constexpr int kNewestVersion = 9;

/// @return The y of "1.y", zero or more; nothing for other texts.
std::optional<int> parseVersion(std::string_view text);

/// @return The y of a file's version 1.y, clamped to the supported ones; the newest, with an error, if none is given.
int readVersion(const Element& root, Diagnostics& diagnostics);

}  // namespace pongsim::sdf
