#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "log/record/folder_lock.hh"

namespace pongsim::log {

/// The recording's file in its folder, with Fortress's name.
inline constexpr const char* kStateFile = "state.tlog";

/// Where a recording is stored.
struct RecordFolder {
  std::filesystem::path folder;
  /// The zip file made at the end, if any.
  std::filesystem::path zip;
  /// Held during the recording.
  std::optional<FolderLock> lock = {};
};

/// What to do if the folder or zip file already exists.
enum class WhereTaken {
  /// Replace the files that a recording consists of, as Fortress does if the world names the folder.
  kReplaceFiles,
  /// Use PATH(1), PATH(2) and so on, as Fortress does if the command line names it.
  kTakeAnother,
  /// Delete both.
  kDelete,
};

/// @return Fortress's default: HOME/.ignition/gazebo/log/TIME.
std::filesystem::path defaultRecordFolder();

/// Creates the folder.
/// @param zip Empty: the folder's name with ".zip".
/// @throws Failure if it can't be created, or another recording uses it.
RecordFolder makeRecordFolder(std::filesystem::path folder, const std::filesystem::path& zip, WhereTaken where);

}  // namespace pongsim::log
