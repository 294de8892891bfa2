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

/// A refused state changes nothing: what has been restored of it is overwritten with what was there before. Only joints
/// of the file can't come back where models were inserted or removed since the start; where a forged state has removed
/// some, and is refused afterwards, the reason says that the world is now another.
Outcome<void> restoreState(std::span<const std::byte> bytes, Access& access, SystemSet& systems);

}  // namespace pongsim::sim
