#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/hulls/hull.hh"

namespace pongsim::physics {

/// @return The hulls as bytes, every bit of them.
std::string encodeHulls(const std::vector<Hull>& hulls);

/// @return The hulls; nothing where the bytes are not those of one hull at least, with corners and margins that can be.
std::optional<std::vector<Hull>> decodeHulls(std::string_view bytes);

}  // namespace pongsim::physics
