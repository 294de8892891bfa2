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
  /// @return The line, without its end; empty where it is not known or the file can't be read any more. It stays until
  /// this goes away.
  std::string_view at(const SourcePosition& position);

 private:
  struct File {
    std::string text;
    /// Where each line begins.
    std::vector<std::size_t> lines;
  };
  const File& fileNamed(const std::string& name);
  std::unordered_map<std::string, File> files_;
};

/// Says on stderr what was found wrong.
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
