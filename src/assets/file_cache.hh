#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::assets {

/// What was worked out once and is kept for later runs, in files of a folder. Any number of processes may use the same
/// folder at once, and anybody may empty it at any time.
class FileCache {
 public:
  /// @param folder Made when something is kept; empty: nothing is.
  /// @param mostBytes When the files are more, the oldest ones go, down to three quarters of that.
  explicit FileCache(std::filesystem::path folder, std::uintmax_t mostBytes = std::uintmax_t{128} << 20U);

  /// @return pongsim/meshes in $XDG_CACHE_HOME, or in ~/.cache where that is not an absolute path; empty where there is
  /// neither.
  static std::filesystem::path userFolder();

  const std::filesystem::path& folder() const { return folder_; }

  /// @param name Letters, digits, "-" and "_".
  /// @return What was kept by that name; nothing where there is nothing, or where the file is not whole.
  std::optional<std::string> find(std::string_view name) const;

  /// Others see all of it or nothing.
  /// @return Why it could not be kept; empty where it was.
  std::string keep(std::string_view name, std::string_view bytes) const;

 private:
  void prune() const;

  std::filesystem::path folder_;
  std::uintmax_t mostBytes_;
};

}  // namespace pongsim::assets
