#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::log {

/// How the chunks of an MCAP file are compressed.
enum class Compression { kNone, kLz4, kZstd };

/// @return MCAP's name: "", "lz4", "zstd".
std::string_view compressionName(Compression compression);
std::optional<Compression> compressionOf(std::string_view name);

/// Compresses chunks one after another, reusing memory.
class Packer {
 public:
  explicit Packer(Compression compression);
  ~Packer();
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// @return The compressed bytes, valid until the next call.
  /// @throws Failure if there is not enough memory.
  std::string_view pack(std::string_view bytes);

 private:
  struct Contexts;
  const Compression compression_;
  std::unique_ptr<Contexts> contexts_;
  std::string packed_;
};

/// Maximum uncompressed size of a chunk, because a small file could claim any size.
inline constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 29U;

/// @param size The uncompressed size, at most `kMostUnpacked`. Memory is allocated only as data arrives.
/// @throws Failure, without a position, if the result is longer or shorter, or the data is invalid.
std::string unpack(Compression compression, std::string_view packed, std::uint64_t size);

/// @return The CRC-32 of ISO 3309, as in zlib; of bytes that follow those of `before`.
std::uint32_t crc32Of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace pongsim::log
