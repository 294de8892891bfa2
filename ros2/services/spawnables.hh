#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

/// @param folders Where models are looked for: those in them are named "model://NAME".
/// @param sources More folders, whose models are named by their paths; a source may be a model's folder itself. What is
/// no such folder is named in the error's text.
/// @param resolve From an address to its file or folder.
/// @return All folders with a `model.config`, sorted by address, each once.
simulation_interfaces::srv::GetSpawnables::Response spawnables(
    const std::vector<std::filesystem::path>& folders, const std::vector<std::string>& sources,
    const std::function<std::optional<std::filesystem::path>(const std::string&)>& resolve);

}  // namespace pongsim::ros2
