#include "web/pictures/jpeg.hh"

#include <csetjmp>
// jpeglib.h needs it
#include <cstdio>

#include <jpeglib.h>

#include <array>
#include <cassert>
#include <cstdlib>
#include <stdexcept>

namespace pongsim::web {

namespace {

/// An image being encoded by libjpeg. On errors the library jumps by `longjmp` to `write`, which has no local objects
/// with destructors.
class JpegWriter {
 public:
  JpegWriter() {
    info_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = fail;
  }
  ~JpegWriter() {
    jpeg_destroy_compress(&info_);
    std::free(bytes_);
  }
  JpegWriter(const JpegWriter&) = delete;
  JpegWriter& operator=(const JpegWriter&) = delete;

  /// @return False if it failed; then `text` says why, else it is the file.
  bool write(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height, int quality) {
    if (setjmp(errors_.back) != 0) return false;
    jpeg_create_compress(&info_);
    jpeg_mem_dest(&info_, &bytes_, &size_);
    info_.image_width = width;
    info_.image_height = height;
    info_.input_components = 3;
    info_.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info_);
    jpeg_set_quality(&info_, quality, TRUE);
    jpeg_start_compress(&info_, TRUE);
    while (info_.next_scanline < height) {
      // the library does not write to it
      JSAMPROW row = const_cast<JSAMPROW>(pixels.data()) + std::size_t{3} * info_.next_scanline * width;
      jpeg_write_scanlines(&info_, &row, 1);
    }
    jpeg_finish_compress(&info_);
    return true;
  }

  std::string file() const { return {reinterpret_cast<const char*>(bytes_), size_}; }
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

  Errors errors_;
  unsigned char* bytes_ = nullptr;
  unsigned long size_ = 0;
  jpeg_compress_struct info_{};
};

}  // namespace

std::string jpegOf(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height, int quality) {
  assert(pixels.size() == std::size_t{3} * width * height);
  JpegWriter writer;
  if (!writer.write(pixels, width, height, quality)) throw std::runtime_error(writer.reason());
  return writer.file();
}

}  // namespace pongsim::web
