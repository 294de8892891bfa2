#pragma once

#include <filesystem>
#include <string>

namespace pongsim::cli {

/// Finds a world's file as Fortress does: as given, else in the resource folders that the environment names
/// (`assets::Places`), else among the worlds that came with this program.
/// @return Its path; `name` itself where there is no such file.
std::filesystem::path findWorldFile(const std::string& name);

}  // namespace pongsim::cli
