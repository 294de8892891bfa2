#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "assets/problem.hh"

namespace pongsim::assets {

/// An image in colours (sRGB).
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Red, green, blue, opacity, 0 to 255, row by row from the top.
  std::vector<std::uint8_t> pixels;
};

/// Pictures with more pixels are refused.
inline constexpr std::size_t kMostPicturePixels = std::size_t{4096} * 4096;

/// Reads a PNG or JPEG file, whatever it is called.
std::variant<Picture, Problem> readPicture(const std::filesystem::path& file);

/// Writes a PNG file, in place of one that is there.
/// @param pixels Red, green, blue: three times width times height, row by row from the top.
/// @return Why it can't be written, or nothing.
std::optional<Problem> writePicture(const std::filesystem::path& file, std::size_t width, std::size_t height,
                                    std::span<const std::uint8_t> pixels);

}  // namespace pongsim::assets
