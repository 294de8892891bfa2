#pragma once

#include <filesystem>
#include <optional>

namespace pongsim::log {

/// Keeps a folder for one recording: of this process or any other on the machine. It ends with its process, too.
class FolderLock {
 public:
  /// @param folder Is there.
  /// @return Nothing where somebody else has it.
  static std::optional<FolderLock> take(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;

 private:
  explicit FolderLock(int file) : file_(file) {}

  /// -1: none, of a file system that has no locks, or one that was moved away.
  int file_;
};

}  // namespace pongsim::log
