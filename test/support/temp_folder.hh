#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::test {

/// A new, empty folder that goes away with this object, whatever is in it.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file in it, in folders below it where `name` has some.
  /// @return The file's full path.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace pongsim::test
