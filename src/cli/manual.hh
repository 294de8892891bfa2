#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// A page for man(1), in troff.
struct ManualPage {
  /// Of the file: "pongsim-run.1".
  std::string file;
  std::string text;
};

/// @return A page for the program and one for each of its commands, of the words that `--help` prints.
std::vector<ManualPage> manualPages(const CLI::App& program);

/// Writes them into a folder.
/// @return Whether it could.
bool writeManual(const CLI::App& program, const std::string& folder);

}  // namespace pongsim::cli
