#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/api/access.hh"
#include "sim/system_set.hh"

namespace pongsim::sim {

// The format: "pongsim8", a hash of the world's structure, a checksum of the content, and the content.

std::vector<std::byte> saveState(Access& access, SystemSet& systems);

/// A refused state changes nothing: a partial restoration is undone by restoring the previous state. The exception are
/// joints of the file, which can't be made again if models have been inserted or removed since the start. If a forged
/// state has removed some and is refused later, the returned error says that the world has changed.
Outcome<void> restoreState(std::span<const std::byte> bytes, Access& access, SystemSet& systems);

}  // namespace pongsim::sim
