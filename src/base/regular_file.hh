#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "base/file_descriptor.hh"

namespace pongsim::base {

/// Why a file can't be read, as it stands behind the file's name: "no such file", "is a named pipe, not a file".
struct Unreadable {
  std::string reason;
};

/// A regular file, open for reading. Whatever a world, a model, a mesh or a request names is opened here: a named pipe,
/// a device or a socket would stop the simulation or never end, so it is refused without waiting for it.
class RegularFile {
 public:
  static std::variant<RegularFile, Unreadable> open(const std::filesystem::path& file);

  /// Its size in bytes when it was opened.
  std::uint64_t size() const { return size_; }
  /// @return How many bytes were read, fewer than asked for only at the end; unset if reading failed, `errno` says why.
  std::optional<std::size_t> readAt(std::uint64_t offset, std::span<char> bytes) const;

 private:
  RegularFile(FileDescriptor descriptor, std::uint64_t size) : descriptor_(std::move(descriptor)), size_(size) {}

  FileDescriptor descriptor_;
  std::uint64_t size_;
};

/// @return The whole content, of at most `largest` bytes.
std::variant<std::string, Unreadable> readRegularFile(const std::filesystem::path& file, std::uint64_t largest);

}  // namespace pongsim::base
