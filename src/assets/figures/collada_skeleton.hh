#pragma once

#include <optional>
#include <string>

#include "assets/figures/skeleton.hh"

namespace pongsim::assets {

/// Reads the skeleton from the content of a Collada file; see `readSkeleton`.
/// @throws std::runtime_error with the line and the fault.
std::optional<Skeleton> colladaSkeleton(const std::string& content);

}  // namespace pongsim::assets
