#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "log/record/folder_lock.hh"

namespace pongsim::log {

/// The file of a recording in its folder, as Fortress names it.
inline constexpr const char* kStateFile = "state.tlog";

/// Where a recording goes.
struct RecordFolder {
  std::filesystem::path folder;
  /// Into which it is packed at the end, if at all.
  std::filesystem::path zip;
  /// While it is recorded into.
  std::optional<FolderLock> lock = {};
};

/// What is done where there is such a folder or zip file already.
enum class WhereTaken {
  /// The files in it that a recording has are replaced, as Fortress does where the world names the folder.
  kReplaceFiles,
  /// PATH(1), PATH(2) and so on is taken, as Fortress does where the command line names it.
  kTakeAnother,
  /// Both are deleted.
  kDelete,
};

/// @return HOME/.ignition/gazebo/log/TIME, as Fortress has it.
std::filesystem::path defaultRecordFolder();

/// Makes the folder.
/// @param zip Empty: the folder's name with ".zip".
/// @throws Failure where it can't be made, or another recording has it.
RecordFolder makeRecordFolder(std::filesystem::path folder, const std::filesystem::path& zip, WhereTaken where);

}  // namespace pongsim::log
