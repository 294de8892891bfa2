#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::web {

/// @return The media type of a file by its extension; empty if pages and worlds do not use such files, which are then
/// not served.
std::string_view mediaType(const std::filesystem::path& file);

}  // namespace pongsim::web
