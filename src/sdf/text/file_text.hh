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

/// Who names a file to read.
enum class NamedBy {
  /// The person or program that starts: may be a pipe or /dev/stdin.
  kUser,
  /// Another file or a request: regular files only, because reading anything else may never end.
  kContent
};

/// Reads a whole file.
/// @param name Its name in diagnostics.
/// @return Nothing, with an error, if it can't be read, is empty or is too large.
std::optional<std::string> readFileText(const std::filesystem::path& file, std::shared_ptr<const std::string> name,
                                        NamedBy by, Diagnostics& diagnostics);

}  // namespace pongsim::sdf
