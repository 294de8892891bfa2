#pragma once

#include <optional>
#include <string_view>

#include "pongsim/element.hh"

namespace pongsim::sdf {

inline constexpr int kOldestVersion = 4;
inline constexpr int kNewestVersion = 12;
/// That of Fortress.
inline constexpr int kFortressVersion = 9;

/// @return The y of "1.y", zero or more; nothing for other texts.
std::optional<int> parseVersion(std::string_view text);

/// @return The version that `upgrade` makes of a file: for versions that Fortress knows, that of Fortress.
constexpr int upgradedVersion(int version) { return version <= kFortressVersion ? kFortressVersion : kNewestVersion; }

/// @return The y of a file's version 1.y, clamped to the supported ones; that of Fortress, with an error, if none is
/// given.
int readVersion(const Element& root, Diagnostics& diagnostics);

}  // namespace pongsim::sdf
