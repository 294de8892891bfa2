#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "log/record/record_folder.hh"

namespace pongsim::log {

/// The folder of a recording of several worlds that run beside each other: each records into a folder of its own in it.
/// May be used by any thread.
class WorldsFolder {
 public:
  /// @param wanted Empty: the default folder.
  /// @return The one that others of this process record into now and asked for by the same words; else one that is
  /// made.
  /// @throws Failure as `makeRecordFolder` does.
  static std::shared_ptr<WorldsFolder> join(const std::string& wanted, const std::string& zip, WhereTaken where);

  /// Makes a world's folder, under its name.
  /// @throws Failure where it can't be made, or another recording has it.
  RecordFolder folderOf(std::string_view world) const;

  /// Gives it up. The last one who does packs it, where it is to be.
  /// @throws Failure where it can't be packed.
  static void leave(std::shared_ptr<WorldsFolder> folder, bool mustPack);

 private:
  explicit WorldsFolder(RecordFolder all) : all_(std::move(all)) {}

  const RecordFolder all_;
};

/// Packs a recording into its zip file, and deletes its folder.
/// @throws Failure where it can't be packed.
void packRecording(const RecordFolder& recording);

}  // namespace pongsim::log
