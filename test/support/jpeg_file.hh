#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <jpeglib.h>

namespace pongsim::test {

/// Settings of the written file.
struct JpegKind {
  J_COLOR_SPACE given = JCS_RGB;
  J_COLOR_SPACE written = JCS_YCbCr;
  bool isProgressive = false;
  bool hasAdobeMarker = false;
  /// One scan for each frequency of each colour, 190 in all.
  bool hasManyScans = false;
  /// 0 to 100; 100 loses hardly anything.
  int quality = 75;
};

/// @param colorOf The colour of all pixels of a row, counted from the top, with as many bytes as `kind.given` has
/// components.
/// @return The content of a square JPEG file.
inline std::string jpegFile(unsigned edge, const std::function<std::vector<std::uint8_t>(unsigned row)>& colorOf,
                            const JpegKind& kind) {
  jpeg_compress_struct info;
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = info.image_height = edge;
  info.input_components = static_cast<int>(colorOf(0).size());
  info.in_color_space = kind.given;
  jpeg_set_defaults(&info);
  jpeg_set_colorspace(&info, kind.written);
  jpeg_set_quality(&info, kind.quality, TRUE);
  info.write_Adobe_marker = kind.hasAdobeMarker ? TRUE : FALSE;
  if (kind.isProgressive) jpeg_simple_progression(&info);
  std::vector<jpeg_scan_info> scans;
  if (kind.hasManyScans) {
    scans.push_back({3, {0, 1, 2, 0}, 0, 0, 0, 0});
    for (int component = 0; component < 3; ++component) {
      for (int frequency = 1; frequency < 64; ++frequency) {
        scans.push_back({1, {component, 0, 0, 0}, frequency, frequency, 0, 0});
      }
    }
    info.scan_info = scans.data();
    info.num_scans = static_cast<int>(scans.size());
  }
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < edge) {
    const std::vector<std::uint8_t> color = colorOf(info.next_scanline);
    std::vector<std::uint8_t> row;
    for (unsigned i = 0; i < edge; ++i) row.insert(row.end(), color.begin(), color.end());
    JSAMPROW rows = row.data();
    jpeg_write_scanlines(&info, &rows, 1);
  }
  jpeg_finish_compress(&info);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&info);
  std::free(bytes);
  return file;
}

/// @param color Colour of all pixels.
inline std::string jpegFile(unsigned edge, const std::vector<std::uint8_t>& color, const JpegKind& kind) {
  return jpegFile(
      edge, [&](unsigned) { return color; }, kind);
}

}  // namespace pongsim::test
