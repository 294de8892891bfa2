#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/export.hh"

namespace pongsim {

/// Pixels of a picture as in its file, not linearised.
struct ParameterPicture {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Red, green, blue, opacity, 0 to 255, row by row from the top.
  std::vector<std::uint8_t> pixels;
};

/// Reads the picture (PNG, JPEG, TGA or BMP) that a parameter of a system names, as `parameterFile` does.
/// @throws Error with the position of the element if there is none that can be read.
PONGSIM_API ParameterPicture parameterPicture(const Element& element);

}  // namespace pongsim
