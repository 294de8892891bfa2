#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

/// @param folders Where to look for models: those inside are named "model://NAME".
/// @param sources Further folders, whose models are named by their paths; a source can also be a model's own folder.
/// Sources that are not such folders are named in the error.
/// @param resolve Converts an address to its file or folder.
/// @return All folders with a `model.config`, sorted by address, each once.
simulation_interfaces::srv::GetSpawnables::Response spawnables(
    const std::vector<std::filesystem::path>& folders, const std::vector<std::string>& sources,
    const std::function<std::optional<std::filesystem::path>(const std::string&)>& resolve);

}  // namespace pongsim::ros2
