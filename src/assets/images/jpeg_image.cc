#include "assets/images/jpeg_image.hh"

#include <array>
#include <cassert>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <jpeglib.h>

// must follow jpeglib.h
#include <jerror.h>

namespace pongsim::assets {

namespace {

// Limit for progressive files, because each scan takes a pass over the image. Usual files have a dozen scans.
constexpr int kMostScans = 100;

/// A JPEG file's content being decoded by libjpeg. On errors the library jumps by `longjmp` to the member function that
/// called it; these functions have no local objects with destructors.
class JpegReader {
 public:
  explicit JpegReader(std::string_view content) : content_(content) {
    info_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = fail;
    errors_.manager.emit_message = failIfDamaged;
    progress_.progress_monitor = countScans;
  }
  ~JpegReader() { jpeg_destroy_decompress(&info_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  /// @return False if it can't be read; then `reason` says why.
  bool readHeader() {
    if (setjmp(errors_.back) != 0) return false;
    jpeg_create_decompress(&info_);
    info_.progress = &progress_;
    jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(content_.data()), content_.size());
    jpeg_read_header(&info_, TRUE);
    return true;
  }

  /// @param pixels Four bytes each: as in `Picture`, or cyan, magenta, yellow, black.
  /// @return False if they can't be read; then `reason` says why.
  bool readPixels(std::span<std::uint8_t> pixels) {
    if (setjmp(errors_.back) != 0) return false;
    info_.out_color_space = isCmyk() ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg_start_decompress(&info_);
    while (info_.output_scanline < info_.output_height) {
      JSAMPROW row = pixels.data() + std::size_t{4} * info_.output_scanline * info_.output_width;
      jpeg_read_scanlines(&info_, &row, 1);
    }
    jpeg_finish_decompress(&info_);
    return true;
  }

  bool isCmyk() const { return info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK; }
  /// Adobe's programs store the missing amount of ink rather than the amount present.
  bool areInksInverted() const { return info_.saw_Adobe_marker != 0; }
  std::size_t width() const { return info_.image_width; }
  std::size_t height() const { return info_.image_height; }
  std::string reason() const { return errors_.text.data(); }

 private:
  struct Errors {
    jpeg_error_mgr manager{};
    std::jmp_buf back{};
    std::array<char, JMSG_LENGTH_MAX> text{};
  };

  [[noreturn]] static void fail(j_common_ptr info) {
    // the error manager is the first member, as the library intends for extensions
    auto& errors = *reinterpret_cast<Errors*>(info->err);
    errors.manager.format_message(info, errors.text.data());
    std::longjmp(errors.back, 1);
  }

  /// Receives the library's warnings. For damaged files it only warns, and fills in grey; two warnings are about other
  /// things.
  static void failIfDamaged(j_common_ptr info, int level) {
    const int code = info->err->msg_code;
    if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM) fail(info);
  }

  static void countScans(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= kMostScans) return;
    auto& errors = *reinterpret_cast<Errors*>(info->err);
    std::snprintf(errors.text.data(), errors.text.size(), "it has more than %d scans, which is the limit", kMostScans);
    std::longjmp(errors.back, 1);
  }

  std::string_view content_;
  Errors errors_;
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct info_{};
};

/// Converts inks to colours: each ink removes its share of the light, black removes it from all colours.
void makeColors(std::span<std::uint8_t> pixels, bool areInverted) {
  assert(pixels.size() % 4 == 0);
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    if (!areInverted) {
      for (std::size_t ink = 0; ink < 4; ++ink) pixels[i + ink] = static_cast<std::uint8_t>(255 - pixels[i + ink]);
    }
    const unsigned light = pixels[i + 3];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      pixels[i + channel] = static_cast<std::uint8_t>((pixels[i + channel] * light + 127) / 255);
    }
    pixels[i + 3] = 255;
  }
}

}  // namespace

std::variant<Picture, Problem> readJpeg(std::string_view content, std::size_t mostPixels) {
  JpegReader reader(content);
  if (!reader.readHeader()) return Problem{"can't be read as a JPEG image: " + reader.reason(), {}};
  if (reader.width() * reader.height() > mostPixels) return tooManyPixels(mostPixels);
  Picture picture{reader.width(), reader.height(), {}};
  picture.pixels.resize(4 * picture.width * picture.height);
  if (!reader.readPixels(picture.pixels)) return Problem{"can't be read as a JPEG image: " + reader.reason(), {}};
  if (reader.isCmyk()) makeColors(picture.pixels, reader.areInksInverted());
  return picture;
}

}  // namespace pongsim::assets
