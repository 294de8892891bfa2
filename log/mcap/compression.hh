#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::log {

/// How the chunks of an MCAP file are packed.
enum class Compression { kNone, kLz4, kZstd };

/// @return As MCAP has it: "", "lz4", "zstd".
std::string_view compressionName(Compression compression);
std::optional<Compression> compressionOf(std::string_view name);

/// Packs one chunk after the other, with the memory of the first.
class Packer {
 public:
  explicit Packer(Compression compression);
  ~Packer();
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// @return The packed bytes, there until the next call.
  /// @throws Failure where there is no memory for it.
  std::string_view pack(std::string_view bytes);

 private:
  struct Contexts;
  const Compression compression_;
  std::unique_ptr<Contexts> contexts_;
  std::string packed_;
};

/// As many bytes as one chunk may become, for a small file could claim any number.
inline constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 29U;

/// @param size What they must become, at most `kMostUnpacked`. So much memory is taken only as the bytes come to it.
/// @throws Failure, without a place, where they become more, less or nothing.
std::string unpack(Compression compression, std::string_view packed, std::uint64_t size);

/// @return The sum of ISO 3309, as zlib has it; of bytes that follow those of `before`.
std::uint32_t crc32Of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace pongsim::log
