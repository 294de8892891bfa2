#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "assets/problem.hh"

namespace pongsim::assets {

/// A colour image (sRGB).
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Red, green, blue, opacity, 0 to 255, row by row from the top.
  std::vector<std::uint8_t> pixels;
};

/// Images with more pixels are refused.
inline constexpr std::size_t kMostPicturePixels = std::size_t{4096} * 4096;

/// Files with more bytes are refused.
inline constexpr std::size_t kLargestPictureFile = std::size_t{128} << 20U;

/// Reads a PNG, JPEG, TGA or BMP file; its name does not matter.
std::variant<Picture, Problem> readPicture(const std::filesystem::path& file);

/// As above, from the content of such a file.
std::variant<Picture, Problem> decodePicture(std::string_view content);

/// Writes a PNG file, replacing an existing one.
/// @param pixels Red, green, blue: 3 * width * height values, row by row from the top.
/// @return Why it can't be written, or nothing.
std::optional<Problem> writePicture(const std::filesystem::path& file, std::size_t width, std::size_t height,
                                    std::span<const std::uint8_t> pixels);

}  // namespace pongsim::assets
