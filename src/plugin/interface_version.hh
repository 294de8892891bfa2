#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace pongsim::plugin {

/// Reads from a system library which version of the plugin interface it was built for, without loading it: a library of
/// another version may need functions that no longer exist, and then can't be loaded.
/// @return Nothing if the file is not a library for this machine (ELF) or exports no systems.
std::optional<std::uint32_t> interfaceVersion(const std::filesystem::path& path);

}  // namespace pongsim::plugin
