#pragma once

#include <cstdlib>

namespace pongsim::fuzz {

/// Ends the fuzzer where something that must hold does not.
inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace pongsim::fuzz
