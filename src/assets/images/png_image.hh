#pragma once

#include <png.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "assets/problem.hh"

namespace pongsim::assets {

/// libpng's image, freed with this object.
struct PngImage {
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;

  png_image image{};
};

/// Decodes the content of a PNG file into `png`.
/// @param flags libpng's PNG_IMAGE_FLAG_*: how to read it.
/// @return Its pixels row by row from the top: red, green, blue and opacity of each.
std::variant<std::vector<std::uint8_t>, Problem> readRgba(std::string_view content, std::size_t mostPixels,
                                                          png_uint_32 flags, PngImage& png);

}  // namespace pongsim::assets
