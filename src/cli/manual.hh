#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

struct Extension;

/// A page for man(1), in troff.
struct ManualPage {
  /// Of the file: "pongsim-run.1".
  std::string file;
  std::string text;
};

/// @return A page for the program and one for each of its commands, of the words that `--help` prints.
std::vector<ManualPage> manualPages(const CLI::App& program);

/// @return The page of what an extension adds, "pongsim-NAME.1": its command, and its options of `pongsim run`.
/// @param name Of the extension.
ManualPage extensionPage(const Extension& extension, const std::string& name);

/// Writes pages into a folder.
/// @return Whether it could.
bool writeManual(const std::vector<ManualPage>& pages, const std::string& folder);

}  // namespace pongsim::cli
