#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

struct Extension;

/// A manual page for man(1), in troff.
struct ManualPage {
  /// Name of its file: "pongsim-run.1".
  std::string file;
  std::string text;
};

/// @return A page for the program and one for each of its commands, made from the texts of `--help`.
std::vector<ManualPage> manualPages(const CLI::App& program);

/// @return The page of an extension, "pongsim-NAME.1": its command, and its options of `pongsim run`.
/// @param name Name of the extension.
ManualPage extensionPage(const Extension& extension, const std::string& name);

/// Writes pages into a folder.
/// @return Whether it succeeded.
bool writeManual(const std::vector<ManualPage>& pages, const std::string& folder);

}  // namespace pongsim::cli
