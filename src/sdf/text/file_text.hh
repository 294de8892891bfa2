#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// Larger files are refused.
inline constexpr std::size_t kLargestFile = std::size_t{256} << 20U;

/// Reads a whole file.
/// @param name Its name in diagnostics.
/// @return Nothing, with an error, if it can't be read, is empty or is too large.
std::optional<std::string> readFileText(const std::filesystem::path& file, std::shared_ptr<const std::string> name,
                                        Diagnostics& diagnostics);

}  // namespace pongsim::sdf
