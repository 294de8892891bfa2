#include "cli/options/xacro_options.hh"

#include <CLI/App.hpp>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>

#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kResourcePath = "PONGSIM_RESOURCE_PATH";

/// Adds the folders in which files of the packages below a folder are looked for.
void addPackagesIn(const fs::path& folder, std::set<fs::path>& found) {
  std::error_code error;
  if (fs::exists(folder / "package.xml", error)) {
    found.insert(folder.parent_path());
    for (const char* part : {"models", "worlds"}) {
      if (fs::is_directory(folder / part, error)) found.insert(folder / part);
    }
    return;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const bool isHidden = entry.path().filename().string().starts_with('.');
    if (!isHidden && entry.is_directory(error) && !entry.is_symlink(error)) addPackagesIn(entry.path(), found);
  }
}

void usePackages(const std::string& folder) {
  std::error_code error;
  const fs::path path = fs::canonical(folder, error);
  std::set<fs::path> found;
  if (!error) addPackagesIn(path, found);
  if (found.empty()) {
    throw UsageError("there is no ROS package in '" + folder + "'",
                     "--packages takes a folder with package.xml below it");
  }
  const char* before = std::getenv(kResourcePath);
  std::string folders = before != nullptr ? before : "";
  for (const fs::path& each : found) folders += (folders.empty() ? "" : ":") + each.string();
  setenv(kResourcePath, folders.c_str(), 1);
}

}  // namespace

CLI::Option* addPackagesOption(CLI::App& command) {
  return command
      .add_option_function<std::vector<std::string>>(
          "--packages",
          [](const std::vector<std::string>& folders) {
            for (const std::string& folder : folders) usePackages(folder);
          },
          "Find package://NAME, and $(find NAME) of xacro, among the ROS packages below FOLDER")
      ->type_name("FOLDER")
      ->allow_extra_args(false);
}

bool isXacroArgument(const std::string& word) {
  const std::size_t sign = word.find(":=");
  if (sign == 0 || sign == std::string::npos) return false;
  for (const char each : word.substr(0, sign)) {
    if (std::isalnum(static_cast<unsigned char>(each)) == 0 && each != '_' && each != '-') return false;
  }
  return true;
}

void passToXacro(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    if (!isXacroArgument(argument)) {
      const bool isMeant = argument.find('=') != std::string::npos;
      throw UsageError("unexpected argument '" + argument + "'",
                       isMeant ? "arguments of a xacro file are ARG:=VALUE" : "");
    }
    text += argument + "\n";
  }
  if (!text.empty()) setenv("PONGSIM_XACRO_ARGUMENTS", text.c_str(), 1);
}

}  // namespace pongsim::cli
