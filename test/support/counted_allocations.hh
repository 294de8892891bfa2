#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

// Replaces operator new, for programs that count allocations: to be included by one source of such a program
// (pongsim_allocation_test).

namespace pongsim::test {

/// Number of allocations so far.
inline long allocations = 0;

inline void* countedAllocation(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, rounded)) return memory;
  throw std::bad_alloc();
}

}  // namespace pongsim::test

void* operator new(std::size_t size) { return pongsim::test::countedAllocation(size); }
void* operator new[](std::size_t size) { return pongsim::test::countedAllocation(size); }
void* operator new(std::size_t size, std::align_val_t align) {
  return pongsim::test::countedAllocation(size, static_cast<std::size_t>(align));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
