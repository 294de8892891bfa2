#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pongsim::log {

/// A file that is read here and there. It is as long as it was when it was opened.
class InputFile {
 public:
  /// @throws Failure where it can't be read, or is no plain file.
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::uint64_t size() const { return size_; }

  /// @return So many bytes from `offset` on.
  /// @throws Failure where they are not there, are more than can be meant (`kMostAtOnce`), or can't be read.
  std::string read(std::uint64_t offset, std::uint64_t length) const;

  /// The largest chunk that is taken [B], and something for its head.
  static constexpr std::uint64_t kMostAtOnce = (std::uint64_t{1} << 29U) + 4096;

 private:
  int number_;
  std::uint64_t size_ = 0;
};

}  // namespace pongsim::log
