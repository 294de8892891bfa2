#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/extension/extension_value.hh"
#include "pongsim/element.hh"

namespace CLI {
class App;
}

namespace pongsim::cli {

/// What a package that is installed beside pongsim adds to the command line, as its descriptor says it
/// (docs/extensions.md): options of `pongsim run` that give worlds a system with settings, and a command that a program
/// of the package does.
struct Extension {
  /// File name and class of a system.
  struct System {
    std::string file;
    std::string className;
  };
  /// What stands in an element below the `<plugin>`.
  struct Setting {
    std::string element;
    std::string text;
  };
  /// A program that prints a world, in libexec/pongsim of the installation.
  struct WorldSource {
    std::string program;
    /// In front of the option's value.
    std::vector<std::string> arguments;
  };
  struct Option {
    /// "--ros2-config"
    std::string name;
    /// What stands for its value in the help; empty: it takes none.
    std::string value;
    /// Whether it may be left out.
    bool isValueOptional = false;
    /// What that may be. The program of a command sees to its own.
    ExtensionValue allowed;
    std::string help;
    /// The element below the `<plugin>` that has the value; empty: none has.
    std::string element;
    /// What stands in the element, of an option that takes no value.
    std::string fixed;
    bool isRepeated = false;
    /// Whether the value is a file, which may be named from the folder that the user is in.
    bool isFile = false;
    /// What else it says.
    std::vector<Setting> implied;
    /// In place of the extension's.
    std::optional<System> system;
    /// It has the world that is run, of which physics moves nothing; no world file may be given.
    std::optional<WorldSource> world;
    /// Options that may not be given with it.
    std::vector<std::string> excluded;
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
  /// The system that each of the options gives a world.
  System system;
  std::vector<Option> runOptions;
  std::optional<Command> command;
};

/// What options of extensions make of a run.
struct RunAdditions {
  /// The `<plugin>` elements that the user asks for.
  std::vector<Element> systems;
  /// A program that prints the world, with all its arguments.
  std::optional<Extension::WorldSource> world;
  /// The option that names it: "--playback".
  std::string worldOption;
};

/// Options and commands of extensions stand under this heading in the help.
inline constexpr const char* kExtensionGroup = "Extensions";

/// @throws std::runtime_error where the file can't be read as a descriptor, saying why.
Extension readExtension(const std::filesystem::path& file);

/// @return Those that are installed, in the order of their files' names. Of one that can't be read is warned.
std::vector<Extension> installedExtensions();

/// Adds an extension's options to `pongsim run`.
/// @param additions Gets what the user asks for. Must outlive the command.
void addRunOptions(CLI::App& command, const Extension& extension, RunAdditions& additions);

/// Looks at which options of an extension were given to `pongsim run`.
/// @throws UsageError where one was that excludes another one.
void checkExcluded(const CLI::App& command, const Extension& extension);

}  // namespace pongsim::cli
