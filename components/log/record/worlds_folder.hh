#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "log/record/record_folder.hh"

namespace pongsim::log {

/// The folder of a recording of several worlds that run in parallel: each has its own subfolder. Can be used by any
/// thread.
class WorldsFolder {
 public:
  /// @param wanted Empty: the default folder.
  /// @return The folder that others in this process are recording into after the same request; else a new one.
  /// @throws Failure like `makeRecordFolder`.
  static std::shared_ptr<WorldsFolder> join(const std::string& wanted, const std::string& zip, WhereTaken where);

  /// Creates a world's subfolder, with the world's name.
  /// @throws Failure if it can't be created, or another recording uses it.
  RecordFolder folderOf(std::string_view world) const;

  /// Releases the folder. The last call packs it, if requested.
  /// @throws Failure if it can't be packed.
  static void leave(std::shared_ptr<WorldsFolder> folder, bool mustPack);

 private:
  explicit WorldsFolder(RecordFolder all) : all_(std::move(all)) {}

  const RecordFolder all_;
};

/// Packs a recording into its zip file, and deletes its folder.
/// @throws Failure if it can't be packed.
void packRecording(const RecordFolder& recording);

}  // namespace pongsim::log
