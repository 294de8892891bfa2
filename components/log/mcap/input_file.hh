#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pongsim::log {

/// A file opened for random access. Its size is that at the time of opening.
class InputFile {
 public:
  /// @throws Failure if it can't be read, or is not a regular file.
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::uint64_t size() const { return size_; }

  /// @return `length` bytes starting at `offset`.
  /// @throws Failure if they are not there, are implausibly many (`kMostAtOnce`), or can't be read.
  std::string read(std::uint64_t offset, std::uint64_t length) const;

  /// Size of the largest accepted chunk, plus room for its head [B].
  static constexpr std::uint64_t kMostAtOnce = (std::uint64_t{1} << 29U) + 4096;

 private:
  int number_;
  std::uint64_t size_ = 0;
};

}  // namespace pongsim::log
