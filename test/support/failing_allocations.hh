#pragma once

#include <cstdlib>
#include <new>

// Replaces operator new, for programs that let allocations fail: to be included by one source of such a program
// (pongsim_allocation_test).

namespace pongsim::test {

/// Number of this thread's allocations until one fails, counted down; 0: none will fail.
inline thread_local long allocationsUntilFailure = 0;

inline void* allocateOrFail(std::size_t size) noexcept {
  if (allocationsUntilFailure > 0 && --allocationsUntilFailure == 0) return nullptr;
  return std::malloc(size);
}

inline void* allocateOrThrow(std::size_t size) {
  if (void* memory = allocateOrFail(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace pongsim::test

void* operator new(std::size_t size) { return pongsim::test::allocateOrThrow(size); }
void* operator new[](std::size_t size) { return pongsim::test::allocateOrThrow(size); }
// replaced, too, because memory of a sanitizer's must not be freed with free
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return pongsim::test::allocateOrFail(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return pongsim::test::allocateOrFail(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
