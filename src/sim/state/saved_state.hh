#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/api/access.hh"
#include "sim/system_set.hh"

namespace pongsim::sim {

// The bytes: "pongsim5", a number made of who is in the world, a number made of the rest, and the rest.

std::vector<std::byte> saveState(Access& access, SystemSet& systems);

/// A refused state changes nothing.
Outcome<void> restoreState(std::span<const std::byte> bytes, Access& access, SystemSet& systems);

}  // namespace pongsim::sim
