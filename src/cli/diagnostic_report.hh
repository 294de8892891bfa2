#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pongsim/diagnostic.hh"

namespace pongsim::cli {

/// The lines of the files that diagnostics speak of.
class SourceLines {
 public:
  /// @return The line, or the part of it around the column; empty where it is not known or the file can't be read any
  /// more. It stays until this goes away.
  SourceExcerpt at(const SourcePosition& position);

 private:
  struct File {
    std::string text;
    /// Where each line begins, and where one more would.
    std::vector<std::size_t> lines;
    /// Of a long line, by its number: where some of its letters begin, the same number of letters apart.
    std::unordered_map<std::size_t, std::vector<std::size_t>> marks;
  };
  File& fileNamed(const std::string& name);
  std::unordered_map<std::string, File> files_;
};

/// Says on stderr what was found wrong, in colours on a terminal.
/// @param least Warnings are left out if this is `kError`.
/// @param leastWithLine What is at least this bad comes with the line of its file and a mark under it.
void say(const Diagnostics& diagnostics, Severity least, Severity leastWithLine);

/// @return The same with all warnings as errors, which `--strict` wants.
Diagnostics asErrors(const Diagnostics& diagnostics);

/// @return A line of JSON: an array of objects with the members "file", "line", "column" (those that are known),
/// "severity"
/// ("error" or "warning"), "message", "hint" (if there is one) and "includedFrom", an array of places.
std::string jsonOf(const std::vector<Diagnostic>& diagnostics);

}  // namespace pongsim::cli
