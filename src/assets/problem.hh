#pragma once

#include <string>

namespace pongsim::assets {

/// Why a file is of no use, in a sentence that follows its name: "holds no triangles".
struct Problem {
  std::string text;
  std::string hint;
};

}  // namespace pongsim::assets
