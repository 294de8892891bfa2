#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "plugin/library.hh"
#include "pongsim/declaration.hh"

namespace pongsim::plugin {

/// A system library, inspected without a simulation: its classes, and how each describes itself.
class Inspection {
 public:
  struct Class {
    /// The preferred one first.
    std::vector<std::string> names;
    std::unique_ptr<System> system;
    Declaration declaration;
  };

  /// @return The library's content, or why it can't be used.
  static std::variant<Inspection, std::string> of(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return library_->file(); }
  const std::vector<Class>& classes() const { return classes_; }

 private:
  explicit Inspection(std::unique_ptr<Library> library);

  std::unique_ptr<Library> library_;
  // destroyed before their library
  std::vector<Class> classes_;
};

/// @return The library that a plugin's filename stands for, in any of the forms that worlds use; nothing if no folder
/// of the search path has it.
std::optional<std::filesystem::path> findLibrary(const std::vector<std::filesystem::path>& searchPath,
                                                 std::string_view filename);

/// @return All libraries in the folders, sorted within each folder; if several have the same name, the first one, which
/// is the one that worlds get.
std::vector<std::filesystem::path> librariesIn(const std::vector<std::filesystem::path>& searchPath);

/// @return The short names of the systems in those libraries.
std::vector<std::string> systemsIn(const std::vector<std::filesystem::path>& searchPath);

}  // namespace pongsim::plugin
