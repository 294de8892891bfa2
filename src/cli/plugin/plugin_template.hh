#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// @return What is wrong with the `name` of a new plugin, or nothing: it consists of lower-case letters, digits and
/// single hyphens, as in "my-system".
std::optional<std::string> pluginNameError(std::string_view name);

/// Writes a new system, ready to build, into a new folder: its source, test, world and page.
/// @param name A valid name.
/// @return Why it failed, or nothing.
std::optional<std::string> writePluginTemplate(const std::filesystem::path& folder, const std::string& name);

}  // namespace pongsim::cli
