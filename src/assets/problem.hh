#pragma once

#include <cstddef>
#include <string>

namespace pongsim::assets {

/// Why a file can't be used, as a phrase that follows its name: "contains no triangles".
struct Problem {
  std::string text;
  std::string hint;
};

/// @return The problem that an image has too many pixels.
inline Problem tooManyPixels(std::size_t most) {
  return {"has more than " + std::to_string(most) + " pixels, which is the limit", {}};
}

}  // namespace pongsim::assets
