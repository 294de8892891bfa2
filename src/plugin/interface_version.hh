#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace pongsim::plugin {

/// Reads from a system library which version of the plugin interface it was built for, without loading it: one of
/// another version may want functions that are no more, and then can't be loaded to be asked.
/// @return Nothing where the file is no library of this machine's kind (ELF) or exports no systems.
std::optional<std::uint32_t> interfaceVersion(const std::filesystem::path& path);

}  // namespace pongsim::plugin
