#pragma once

#include <string_view>
#include <variant>

#include "assets/images/gray_image.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Decodes the first channel of the first image of a TIFF file; that of a GeoTIFF, without its position on earth.
/// @return The image, or why it can't be read. Unsigned numbers of 16 bits become 8 bits by their upper half. Signed,
/// wider and floating-point numbers, such as elevations, are scaled so that the lowest becomes 0 and the highest 255;
/// those that stand for missing data, NaN and -9999 or less, count as the lowest.
std::variant<GrayImage, Problem> readTiff(std::string_view content, std::size_t mostPixels);

}  // namespace pongsim::assets
