#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace pongsim::log {

/// A new file that is written from front to back.
class OutputFile {
 public:
  /// @param overwrites A file that is there already; it is an error else.
  /// @throws Failure where the file can't be made.
  OutputFile(std::filesystem::path path, bool overwrites);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @throws Failure where they can't be written, as where the disk is full.
  void write(std::string_view bytes);
  /// @return Bytes written so far.
  std::uint64_t size() const { return size_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int number_;
  std::uint64_t size_ = 0;
};

}  // namespace pongsim::log
