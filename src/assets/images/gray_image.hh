#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <variant>
#include <vector>

#include "assets/problem.hh"

namespace pongsim::assets {

/// The red channel of an image; for a grey image, its brightness.
struct GrayImage {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Row by row from the top, 0 to 255.
  std::vector<std::uint8_t> pixels;

  std::uint8_t at(std::size_t column, std::size_t row) const { return pixels[row * width + column]; }
};

/// Images with more pixels are refused.
inline constexpr std::size_t kMostPixels = 1'000'000;

/// Reads a PNG, JPEG or TIFF file; its name does not matter.
std::variant<GrayImage, Problem> readGrayImage(const std::filesystem::path& file);

}  // namespace pongsim::assets
