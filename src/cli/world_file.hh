#pragma once

#include <filesystem>
#include <string>

namespace pongsim::cli {

/// Finds a world's file as Fortress does: as given, else in the folders of IGN_GAZEBO_RESOURCE_PATH and
/// GZ_SIM_RESOURCE_PATH, else among the worlds that came with this program.
/// @return Its path; `name` itself where there is no such file.
std::filesystem::path findWorldFile(const std::string& name);

}  // namespace pongsim::cli
