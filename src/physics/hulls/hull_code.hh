#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/hulls/hull.hh"

namespace pongsim::physics {

/// @return The hulls as bytes, bit for bit.
std::string encodeHulls(const std::vector<Hull>& hulls);

/// @return The hulls; nothing unless the bytes encode at least one hull with valid corners and margins.
std::optional<std::vector<Hull>> decodeHulls(std::string_view bytes);

}  // namespace pongsim::physics
