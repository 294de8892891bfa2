#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "sdf/text/file_text.hh"

namespace pongsim::sdf {

/// What a file contains, after xacro where it is one of its files.
struct ExpandedText {
  std::string text;
  /// Its name in diagnostics: where it was expanded, lines are not those of the file, and the name says so.
  std::shared_ptr<const std::string> name;
};

/// Reads a whole file like `readFileText`, and expands it if it is one of xacro.
/// @param mayExpand Whether to run xacro, which may read any file; if not, files of xacro are refused.
std::optional<ExpandedText> readExpandedText(const std::filesystem::path& file,
                                         const std::shared_ptr<const std::string>& name, NamedBy by, bool mayExpand,
                                         Diagnostics& diagnostics);

/// @return Whether a file has to be expanded before it can be read: its name ends with ".xacro", or it uses macros.
bool isXacro(const std::filesystem::path& file, std::string_view text);

/// Expands a file by the installed xacro, in another process. The environment variable PONGSIM_XACRO_ARGUMENTS has its
/// arguments, ARG:=VALUE, one per line.
/// @param name The file's name in diagnostics.
/// @return Nothing, with an error, if there is no xacro or it refuses the file; the error then names the file and line.
std::optional<std::string> expandXacro(const std::filesystem::path& file,
                                       const std::shared_ptr<const std::string>& name, Diagnostics& diagnostics);

}  // namespace pongsim::sdf
