#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::security {

/// A folder that is put in place completely or not at all: it is filled next to its destination under a temporary name,
/// and deleted with this object unless it has been put in place. Only its owner has access.
class NewFolder {
 public:
  /// @param beside A folder on the same file system, created if missing.
  /// @throws cli::Failure, like all functions here.
  explicit NewFolder(const std::filesystem::path& beside);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// `name` is relative to the folder, and can include subfolders.
  void write(const std::filesystem::path& name, std::string_view content);
  void link(const std::filesystem::path& name, const std::filesystem::path& target);

  /// Moves it to its destination, unless something other than an empty folder is there.
  /// @return Whether it was moved.
  bool put(const std::filesystem::path& place);

 private:
  std::filesystem::path path_;
};

/// Creates a folder accessible only to its owner, with any missing parents.
/// @throws cli::Failure
void makeFolders(const std::filesystem::path& folder);

}  // namespace pongsim::security
