// Truevision TGA File Format Specification, version 2.0.
#include "assets/images/tga_image.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace pongsim::assets {

namespace {

using Pixel = std::array<std::uint8_t, 4>;

constexpr std::size_t kHeaderBytes = 18;
constexpr unsigned kMapped = 1, kColors = 2, kGray = 3, kRunLength = 8;

unsigned byteAt(std::string_view content, std::size_t at) { return static_cast<std::uint8_t>(content[at]); }
unsigned shortAt(std::string_view content, std::size_t at) {
  return byteAt(content, at) | byteAt(content, at + 1) << 8U;
}

struct TgaHeader {
  explicit TgaHeader(std::string_view content)
      : textBytes(byteAt(content, 0)),
        hasPalette(byteAt(content, 1) == 1),
        kind(byteAt(content, 2)),
        paletteStart(shortAt(content, 3)),
        paletteLength(shortAt(content, 5)),
        paletteBits(byteAt(content, 7)),
        width(shortAt(content, 12)),
        height(shortAt(content, 14)),
        bits(byteAt(content, 16)),
        opacityBits(byteAt(content, 17) & 15U),
        isMirrored((byteAt(content, 17) & 16U) != 0),
        isFromTop((byteAt(content, 17) & 32U) != 0) {}

  std::size_t textBytes;
  bool hasPalette;
  unsigned kind;
  std::size_t paletteStart;
  std::size_t paletteLength;
  unsigned paletteBits;
  std::size_t width;
  std::size_t height;
  unsigned bits;
  unsigned opacityBits;
  bool isMirrored;
  bool isFromTop;
};

std::size_t bytesOf(unsigned bits) { return (bits + 7) / 8; }

/// @param bytes Of one colour, blue first.
Pixel tgaColorOf(std::string_view bytes, bool hasOpacity) {
  if (bytes.size() == 2) {
    const unsigned all = shortAt(bytes, 0);
    const auto channel = [all](unsigned shift) { return static_cast<std::uint8_t>((all >> shift & 31U) * 255 / 31); };
    return {channel(10), channel(5), channel(0), 255};
  }
  const auto channel = [bytes](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
  return {channel(2), channel(1), channel(0), bytes.size() == 4 && hasOpacity ? channel(3) : std::uint8_t{255}};
}

/// Reads a file's pixels in the order in which they are stored.
class PixelReader {
 public:
  PixelReader(std::string_view content, const TgaHeader& header) : header_(header), size_(bytesOf(header.bits)) {
    const std::size_t palette = kHeaderBytes + header.textBytes;
    const std::size_t paletteBytes = header.hasPalette ? header.paletteLength * bytesOf(header.paletteBits) : 0;
    if (palette + paletteBytes > content.size()) return;
    palette_ = content.substr(palette, paletteBytes);
    rest_ = content.substr(palette + paletteBytes);
  }

  /// @return The next pixel; nothing at the end of the file, or for a colour that the palette does not have.
  std::optional<Pixel> next() {
    if ((header_.kind & kRunLength) == 0) return take();
    if (left_ == 0) {
      if (rest_.empty()) return std::nullopt;
      const unsigned packet = byteAt(rest_, 0);
      rest_.remove_prefix(1);
      left_ = (packet & 127U) + 1;
      isRun_ = (packet & 128U) != 0;
      if (isRun_) repeated_ = take();
    }
    --left_;
    return isRun_ ? repeated_ : take();
  }

 private:
  std::optional<Pixel> take() {
    if (rest_.size() < size_) return std::nullopt;
    const std::string_view bytes = rest_.substr(0, size_);
    rest_.remove_prefix(size_);
    const unsigned kind = header_.kind & 7U;
    if (kind == kColors) return tgaColorOf(bytes, header_.opacityBits > 0);
    const std::uint8_t value = static_cast<std::uint8_t>(bytes[0]);
    if (kind == kGray) return Pixel{value, value, value, 255};
    const std::size_t bytesEach = bytesOf(header_.paletteBits), index = value;
    if (index < header_.paletteStart || index - header_.paletteStart >= header_.paletteLength) return std::nullopt;
    return tgaColorOf(palette_.substr((index - header_.paletteStart) * bytesEach, bytesEach), true);
  }

  const TgaHeader& header_;
  std::size_t size_;
  std::string_view palette_;
  std::string_view rest_;
  /// Pixels left of the current packet; its colour, if it is a run of one.
  unsigned left_ = 0;
  bool isRun_ = false;
  std::optional<Pixel> repeated_;
};

bool isKnownDepth(unsigned value, std::initializer_list<unsigned> known) {
  return std::ranges::find(known, value) != known.end();
}

}  // namespace

bool looksLikeTga(std::string_view content) {
  if (content.size() < kHeaderBytes || byteAt(content, 1) > 1) return false;
  const TgaHeader header(content);
  const unsigned kind = header.kind & ~kRunLength;
  if (header.width == 0 || header.height == 0 || header.opacityBits > 8) return false;
  if (kind == kColors) return isKnownDepth(header.bits, {15, 16, 24, 32});
  if (kind == kMapped)
    return header.bits == 8 && header.hasPalette && isKnownDepth(header.paletteBits, {15, 16, 24, 32});
  return kind == kGray && header.bits == 8;
}

std::variant<Picture, Problem> readTga(std::string_view content, std::size_t mostPixels) {
  const auto problem = [](const std::string& what) { return Problem{"can't be read as a TGA image: " + what, {}}; };
  if (!looksLikeTga(content)) return problem("its header is none");
  const TgaHeader header(content);
  if (header.width * header.height > mostPixels) {
    return problem("it has more than " + std::to_string(mostPixels) + " pixels");
  }
  Picture picture{header.width, header.height, {}};
  picture.pixels.resize(4 * header.width * header.height);
  PixelReader reader(content, header);
  for (std::size_t i = 0; i < header.height; ++i) {
    const std::size_t row = header.isFromTop ? i : header.height - 1 - i;
    for (std::size_t j = 0; j < header.width; ++j) {
      const std::size_t column = header.isMirrored ? header.width - 1 - j : j;
      const std::optional<Pixel> pixel = reader.next();
      if (!pixel) return problem("it ends early, or has colours that its palette has not");
      std::ranges::copy(*pixel, &picture.pixels[4 * (row * header.width + column)]);
    }
  }
  return picture;
}

}  // namespace pongsim::assets
