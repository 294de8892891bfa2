#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pongsim/diagnostic.hh"

namespace pongsim::cli {

/// Looks up the source lines that diagnostics refer to.
class SourceLines {
 public:
  /// @return The line, or the part of it around the column; empty if it is unknown or the file can no longer be read.
  /// Valid as long as this object.
  SourceExcerpt at(const SourcePosition& position);

 private:
  struct File {
    std::string text;
    /// Where each line begins, and where the line after the last one would.
    std::vector<std::size_t> lines;
    /// For long lines, by line number: where every n-th character begins.
    std::unordered_map<std::size_t, std::vector<std::size_t>> marks;
  };
  File& fileNamed(const std::string& name);
  std::unordered_map<std::string, File> files_;
};

/// Prints diagnostics on stderr, in colour on a terminal.
/// @param least Warnings are left out if this is `kError`.
/// @param leastWithLine From this severity on, the source line is shown with a marker below it.
void say(const Diagnostics& diagnostics, Severity least, Severity leastWithLine);

/// @return The same with all warnings as errors, for `--strict`.
Diagnostics asErrors(const Diagnostics& diagnostics);

/// @return A line of JSON: an array of objects with the members "file", "line", "column" (those that are known),
/// "severity" ("error" or "warning"), "message", "hint" (if any) and "includedFrom", an array of positions.
std::string jsonOf(const std::vector<Diagnostic>& diagnostics);

}  // namespace pongsim::cli
