#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace pongsim::log {

/// A new file, written sequentially.
class OutputFile {
 public:
  /// @param overwrites Whether an existing file is overwritten; if not, it is an error.
  /// @throws Failure if the file can't be created.
  OutputFile(std::filesystem::path path, bool overwrites);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @throws Failure if they can't be written, for example because the disk is full.
  void write(std::string_view bytes);
  /// Some file systems, such as NFS, report only here that something could not be written. Nothing can be written
  /// afterwards.
  /// @throws Failure like `write`.
  void close();
  /// @return Number of bytes written so far.
  std::uint64_t size() const { return size_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  /// -1: closed.
  int number_;
  std::uint64_t size_ = 0;
};

}  // namespace pongsim::log
