#pragma once

#include <filesystem>
#include <optional>

namespace pongsim::log {

/// Reserves a folder for one recording, among all processes on the machine. Released at the latest when the process
/// ends.
class FolderLock {
 public:
  /// @param folder Must exist.
  /// @return Nothing if it is already locked.
  static std::optional<FolderLock> take(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;

 private:
  explicit FolderLock(int file) : file_(file) {}

  /// -1: none, because the file system has no locks, or because this object was moved from.
  int file_;
};

}  // namespace pongsim::log
