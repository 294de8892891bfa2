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

/// What an additional package adds to the command line, read from its descriptor (docs/extensions.md): options of
/// `pongsim run` that add a system with settings to worlds, and a command implemented by one of the package's programs.
struct Extension {
  /// File name and class of a system.
  struct System {
    std::string file;
    std::string className;
  };
  /// Content of an element inside the `<plugin>`.
  struct Setting {
    std::string element;
    std::string text;
  };
  /// A program that prints a world, in libexec/pongsim of the installation.
  struct WorldSource {
    std::string program;
    /// Arguments that precede the option's value.
    std::vector<std::string> arguments;
  };
  struct Option {
    /// "--ros2-config"
    std::string name;
    /// Placeholder for its value in the help; empty: it takes none.
    std::string value;
    /// Whether the value can be left out.
    bool isValueOptional = false;
    /// Allowed values. The program of a command checks its own.
    ExtensionValue allowed;
    std::string help;
    /// The element inside the `<plugin>` that gets the value; empty: none.
    std::string element;
    /// For options without a value: the element's content.
    std::string fixed;
    bool isRepeated = false;
    /// Whether the value is a file, which can be relative to the current folder.
    bool isFile = false;
    /// Further settings that it implies.
    std::vector<Setting> implied;
    /// Overrides the extension's system.
    std::optional<System> system;
    /// Provides the world to run, in which physics moves nothing; the user must not give a world file.
    std::optional<WorldSource> world;
    /// Options that can't be combined with it.
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
  /// The system that each of the options adds to a world.
  System system;
  std::vector<Option> runOptions;
  std::optional<Command> command;
};

/// The effect of extension options on a run.
struct RunAdditions {
  /// The `<plugin>` elements requested by the user.
  std::vector<Element> systems;
  /// A program that prints the world, with all its arguments.
  std::optional<Extension::WorldSource> world;
  /// The option that selected it: "--playback".
  std::string worldOption;
};

/// Heading in the help for options and commands of extensions.
inline constexpr const char* kExtensionGroup = "Extensions";

/// @throws std::runtime_error if the file is not a valid descriptor, with the reason.
Extension readExtension(const std::filesystem::path& file);

/// @return The installed extensions, sorted by their files' names. Warns about those that can't be read.
std::vector<Extension> installedExtensions();

/// Adds an extension's options to `pongsim run`.
/// @param additions Gets what the user requests. Must outlive the command.
void addRunOptions(CLI::App& command, const Extension& extension, RunAdditions& additions);

/// Checks which options of an extension were given to `pongsim run`.
/// @throws UsageError if one excludes another.
void checkExcluded(const CLI::App& command, const Extension& extension);

}  // namespace pongsim::cli
