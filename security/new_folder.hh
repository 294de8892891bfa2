#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::security {

/// A folder that comes to its place whole or not at all: it is filled beside it, under another name, and goes away with
/// this object unless it has been put there. All is for its owner alone.
class NewFolder {
 public:
  /// @param beside A folder of the same file system, made where it is not there.
  /// @throws programs::Failure, as all of them.
  explicit NewFolder(const std::filesystem::path& beside);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// `name` is relative to the folder, and may stand in folders below it.
  void write(const std::filesystem::path& name, std::string_view content);
  void link(const std::filesystem::path& name, const std::filesystem::path& target);

  /// Puts it to its place, where there may be nothing but an empty folder.
  /// @return Whether there was not.
  bool put(const std::filesystem::path& place);

 private:
  std::filesystem::path path_;
};

/// Makes a folder for its owner alone, and those above it that are missing.
/// @throws programs::Failure
void makeFolders(const std::filesystem::path& folder);

}  // namespace pongsim::security
