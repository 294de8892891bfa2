#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::web {

/// @return What a browser is to take a file for, by its extension; empty where it is none that pages and worlds consist
/// of, which is not sent then.
std::string_view mediaType(const std::filesystem::path& file);

}  // namespace pongsim::web
