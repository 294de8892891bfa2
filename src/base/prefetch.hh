#pragma once

#include <cstddef>
#include <cstdint>

namespace pongsim::base {

/// Starts loading an object's memory into the processor's caches and does not wait for it. Pays in loops over more
/// objects than fit there.
/// @param most Maximum size to prefetch [bytes].
template <class T>
void prefetch(const T& object, std::size_t most = sizeof(T)) {
  constexpr std::uintptr_t kLine = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(&object);
  for (std::uintptr_t line = begin / kLine * kLine; line < begin + most; line += kLine) {
    __builtin_prefetch(reinterpret_cast<const void*>(line), 1, 2);
  }
}

}  // namespace pongsim::base
