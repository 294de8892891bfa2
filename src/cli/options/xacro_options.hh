#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pongsim::cli {

/// Adds the option `--packages FOLDER` to a command that reads worlds: ROS packages below the folder are found by
/// package://NAME and by xacro's $(find NAME); in files of xacro also if their folders have other names. The option
/// adds to the environment variable PONGSIM_RESOURCE_PATH.
CLI::Option* addPackagesOption(CLI::App& command);

/// @return Whether a word of a command line is an argument for xacro: ARG:=VALUE.
bool isXacroArgument(const std::string& word);

/// Passes arguments to the xacro files that this process reads, by the environment variable PONGSIM_XACRO_ARGUMENTS.
/// @throws UsageError if one is not of the form ARG:=VALUE.
void passToXacro(const std::vector<std::string>& arguments);

}  // namespace pongsim::cli
