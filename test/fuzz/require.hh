#pragma once

#include <cstdlib>

namespace pongsim::fuzz {

/// Ends the fuzzer with a failure if the condition does not hold.
inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace pongsim::fuzz
