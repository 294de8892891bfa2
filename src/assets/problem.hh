#pragma once

#include <cstddef>
#include <string>

namespace pongsim::assets {

/// Why a file is of no use, in a sentence that follows its name: "contains no triangles".
struct Problem {
  std::string text;
  std::string hint;
};

/// @return That an image has more pixels than are read.
inline Problem tooManyPixels(std::size_t most) {
  return {"has more than " + std::to_string(most) + " pixels, which is the limit", {}};
}

}  // namespace pongsim::assets
