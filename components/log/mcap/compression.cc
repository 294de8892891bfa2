#include "log/mcap/compression.hh"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

// fast enough beside a simulation, and a third smaller than lz4
constexpr int kZstdLevel = 1;
constexpr std::size_t kStep = std::size_t{1} << 18U;

constexpr std::array<std::pair<Compression, std::string_view>, 3> kNames = {
    {{Compression::kNone, ""}, {Compression::kLz4, "lz4"}, {Compression::kZstd, "zstd"}}};

struct EndsZstd {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};
struct EndsLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

/// A buffer for decompressed bytes. It grows as they arrive, up to the claimed size.
class Unpacked {
 public:
  explicit Unpacked(std::uint64_t size) : size_(size) {}

  /// @return Address and size of the free part: at least one byte more than claimed, so that excess data is detected.
  std::pair<char*, std::size_t> room() {
    if (used_ == bytes_.size()) bytes_.resize(std::min<std::size_t>(size_ + 1, std::max(bytes_.size() * 2, kStep)));
    return {bytes_.data() + used_, bytes_.size() - used_};
  }
  void add(std::size_t count) {
    used_ += count;
    if (used_ > size_) throw Failure("it decompresses to more than the " + std::to_string(size_) + " bytes it claims");
  }
  std::string finish() && {
    if (used_ < size_) {
      throw Failure("it decompresses to " + std::to_string(used_) + " bytes, and claims " + std::to_string(size_));
    }
    bytes_.resize(used_);
    return std::move(bytes_);
  }

 private:
  std::uint64_t size_;
  std::string bytes_;
  std::size_t used_ = 0;
};

std::string unpackZstd(std::string_view packed, std::uint64_t size) {
  const std::unique_ptr<ZSTD_DCtx, EndsZstd> context(ZSTD_createDCtx());
  if (context == nullptr) throw Failure("not enough memory to decompress");
  Unpacked unpacked(size);
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  std::size_t hint = 1;
  while (true) {
    const auto [place, room] = unpacked.room();
    ZSTD_outBuffer out{place, room, 0};
    const std::size_t before = in.pos;
    hint = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(hint) != 0) throw Failure(std::string("zstd: ") + ZSTD_getErrorName(hint));
    unpacked.add(out.pos);
    if (in.pos == in.size && out.pos < room) break;
    if (out.pos == 0 && in.pos == before) throw Failure("zstd: the data is invalid");
  }
  if (hint != 0) throw Failure("zstd: the data is truncated");
  return std::move(unpacked).finish();
}

std::string unpackLz4(std::string_view packed, std::uint64_t size) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0)
    throw Failure("not enough memory to decompress");
  const std::unique_ptr<LZ4F_dctx, EndsLz4> context(made);
  Unpacked unpacked(size);
  std::size_t hint = 1;
  while (true) {
    auto [place, count] = unpacked.room();
    const std::size_t room = count;
    std::size_t taken = packed.size();
    hint = LZ4F_decompress(context.get(), place, &count, packed.data(), &taken, nullptr);
    if (LZ4F_isError(hint) != 0) throw Failure(std::string("lz4: ") + LZ4F_getErrorName(hint));
    packed.remove_prefix(taken);
    unpacked.add(count);
    if (packed.empty() && count < room) break;
    if (taken == 0 && count == 0) throw Failure("lz4: the data is invalid");
  }
  if (hint != 0) throw Failure("lz4: the data is truncated");
  return std::move(unpacked).finish();
}

}  // namespace

std::string_view compressionName(Compression compression) {
  return std::ranges::find(kNames, compression, &std::pair<Compression, std::string_view>::first)->second;
}

std::optional<Compression> compressionOf(std::string_view name) {
  const auto found = std::ranges::find(kNames, name, &std::pair<Compression, std::string_view>::second);
  if (found == kNames.end()) return std::nullopt;
  return found->first;
}

struct Packer::Contexts {
  Contexts() = default;
  ~Contexts() { ZSTD_freeCCtx(zstd); }
  Contexts(const Contexts&) = delete;
  Contexts& operator=(const Contexts&) = delete;
  ZSTD_CCtx* zstd = nullptr;
};

Packer::Packer(Compression compression) : compression_(compression), contexts_(std::make_unique<Contexts>()) {
  if (compression_ != Compression::kZstd) return;
  contexts_->zstd = ZSTD_createCCtx();
  if (contexts_->zstd == nullptr) throw Failure("not enough memory to compress");
}
Packer::~Packer() = default;

std::string_view Packer::pack(std::string_view bytes) {
  if (compression_ == Compression::kNone) return bytes;
  std::size_t size = 0;
  if (compression_ == Compression::kZstd) {
    packed_.resize(std::max(packed_.size(), ZSTD_compressBound(bytes.size())));
    size = ZSTD_compressCCtx(contexts_->zstd, packed_.data(), packed_.size(), bytes.data(), bytes.size(), kZstdLevel);
    if (ZSTD_isError(size) != 0) throw Failure(std::string("zstd: ") + ZSTD_getErrorName(size));
  } else {
    packed_.resize(std::max(packed_.size(), LZ4F_compressFrameBound(bytes.size(), nullptr)));
    size = LZ4F_compressFrame(packed_.data(), packed_.size(), bytes.data(), bytes.size(), nullptr);
    if (LZ4F_isError(size) != 0) throw Failure(std::string("lz4: ") + LZ4F_getErrorName(size));
  }
  return std::string_view(packed_).substr(0, size);
}

std::string unpack(Compression compression, std::string_view packed, std::uint64_t size) {
  if (size > kMostUnpacked) {
    throw Failure("it claims to unpack to " + std::to_string(size) + " bytes, and " + std::to_string(kMostUnpacked) +
                  " is the limit");
  }
  switch (compression) {
    case Compression::kZstd:
      return unpackZstd(packed, size);
    case Compression::kLz4:
      return unpackLz4(packed, size);
    case Compression::kNone:
      break;
  }
  if (packed.size() != size) {
    throw Failure("it has " + std::to_string(packed.size()) + " bytes, and claims " + std::to_string(size));
  }
  return std::string(packed);
}

std::uint32_t crc32Of(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace pongsim::log
