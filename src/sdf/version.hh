#pragma once

#include <optional>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim::sdf {

inline constexpr int kOldestVersion = 4;
inline constexpr int kNewestVersion = 9;

/// @return The y of "1.y", from 0 up; nothing for any other text.
std::optional<int> parseVersion(std::string_view text);

/// @return The version 1.y of a file, within what is supported; the newest, and an error added, where none is given.
int readVersion(const Element& root, Diagnostics& diagnostics);

}  // namespace pongsim::sdf
