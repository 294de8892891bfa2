#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::test {

/// A new, empty folder; the destructor removes it with all its content.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file in the folder; `name` may begin with folders, which are created.
  /// @return The file's full path.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace pongsim::test
