#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::assets {

/// A folder of files that caches results for later runs. Several processes can share the folder, and it can be emptied
/// at any time.
class FileCache {
 public:
  /// @param folder Created when first needed; empty: nothing is cached.
  /// @param mostBytes If the files exceed this, the oldest are deleted, down to three quarters of it.
  explicit FileCache(std::filesystem::path folder, std::uintmax_t mostBytes = std::uintmax_t{128} << 20U);

  /// @return pongsim/meshes in $XDG_CACHE_HOME, or in ~/.cache if that is not an absolute path; empty if neither
  /// exists.
  static std::filesystem::path userFolder();

  const std::filesystem::path& folder() const { return folder_; }

  /// @param name Letters, digits, "-" and "_".
  /// @return The content cached under the name; nothing if there is none, or if the file is incomplete.
  std::optional<std::string> find(std::string_view name) const;

  /// Caches the content atomically: others see all of it or nothing.
  /// @return Why it failed; empty on success.
  std::string keep(std::string_view name, std::string_view bytes) const;

 private:
  void prune() const;

  std::filesystem::path folder_;
  std::uintmax_t mostBytes_;
};

}  // namespace pongsim::assets
