#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// @return What is wrong with `name` as that of a new plugin, or nothing: it is made of small letters, digits and
/// single hyphens, as "my-system".
std::optional<std::string> pluginNameError(std::string_view name);

/// Writes the sources of a new system, which builds, into a new folder: its source, test, world and page.
/// @param name Without an error.
/// @return Why that was not possible, or nothing.
std::optional<std::string> writePluginTemplate(const std::filesystem::path& folder, const std::string& name);

}  // namespace pongsim::cli
