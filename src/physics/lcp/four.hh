#pragma once

namespace pongsim::physics {

/// Four numbers side by side. Memory for rows has the alignment of two.
using Four [[gnu::vector_size(32), gnu::aligned(16), gnu::may_alias]] = double;
/// Likewise, in memory that has the alignment of one.
using Loose [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

/// Sets the sum of each of the four. By reference, for who has no registers that wide passes them in another way.
[[gnu::always_inline]] inline void sumUp(const Four& a, const Four& b, const Four& c, const Four& d, Four& sums) {
  const Four ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  sums = __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

}  // namespace pongsim::physics

// Of a function with this attribute there is one more version for processors with wider registers, which gives the same
// bits: what these do beside each other comes out number by number. It must be internal to its file, for versions of a
// function that others call would be offered by the library, and what it calls must be inlined.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PONGSIM_WIDE [[gnu::target_clones("avx2", "default")]]
#else
#define PONGSIM_WIDE
#endif
