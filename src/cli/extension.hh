#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/element.hh"

namespace CLI {
class App;
}

namespace pongsim::cli {

/// What a package that is installed beside pongsim adds to the command line, as its descriptor says it
/// (docs/extensions.md): options of `pongsim run` that give worlds a system with settings, and a command that a program
/// of the package does.
struct Extension {
  struct Option {
    /// "--ros2-config"
    std::string name;
    /// What stands for its value in the help; empty: it takes none.
    std::string value;
    std::string help;
    /// The element below the `<plugin>` that has the value; empty: none has.
    std::string element;
    /// What stands in the element, of an option that takes no value.
    std::string fixed;
    bool isRepeated = false;
    /// Whether the value is a file, which may be named from the folder that the user is in.
    bool isFile = false;
  };
  struct Action {
    std::string name;
    std::string help;
    std::vector<Option> options;
  };
  struct Command {
    std::string name;
    std::string help;
    /// In libexec/pongsim of the installation.
    std::string program;
    std::vector<Action> actions;
    std::vector<std::string> examples;
  };
  /// The system that each of the options gives a world: file name and class.
  std::string systemFile;
  std::string systemClass;
  std::vector<Option> runOptions;
  std::optional<Command> command;
};

/// Options and commands of extensions stand under this heading in the help.
inline constexpr const char* kExtensionGroup = "Extensions";

/// @throws std::runtime_error where the file can't be read as a descriptor, saying why.
Extension readExtension(const std::filesystem::path& file);

/// @return Those that are installed, in the order of their files' names. Of one that can't be read is warned.
std::vector<Extension> installedExtensions();

/// Adds an extension's options to `pongsim run`.
/// @param systems Gets the `<plugin>` elements of those that the user asks for. Must outlive the command.
void addRunOptions(CLI::App& command, const Extension& extension, std::vector<Element>& systems);

}  // namespace pongsim::cli
