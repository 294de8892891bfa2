#include "base/arena.hh"

#include <sys/mman.h>

#include <cassert>
#include <cstdint>
#include <new>

namespace pongsim::base {

namespace {

constexpr std::size_t kBlock = std::size_t{2} << 20U;

std::size_t unitsOf(std::size_t bytes) { return (bytes + Arena::kAlignment - 1) / Arena::kAlignment; }

// aligned to its size, because the kernel uses a large page only where 2 MiB of memory begin at a multiple of 2 MiB
void* mapBlock() {
  void* const memory = mmap(nullptr, 2 * kBlock, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  auto* const first = static_cast<std::byte*>(memory);
  const std::size_t before = -reinterpret_cast<std::uintptr_t>(memory) % kBlock;
  if (before != 0) munmap(first, before);
  munmap(first + before + kBlock, kBlock - before);
  return first + before;
}

}  // namespace

Arena::~Arena() {
  for (void* block : blocks_) munmap(block, kBlock);
}

void* Arena::allocate(std::size_t bytes) {
  const std::size_t units = unitsOf(bytes);
  if (units >= free_.size()) throw std::bad_alloc();
  if (Free* const found = free_[units]) {
    free_[units] = found->next;
    return found;
  }
  const std::size_t size = units * kAlignment;
  if (static_cast<std::size_t>(end_ - next_) < size) addBlock();
  return std::exchange(next_, next_ + size);
}

void Arena::free(void* memory, std::size_t bytes) noexcept {
  assert(memory != nullptr && bytes > 0 && bytes <= kLargest);
  Free*& first = free_[unitsOf(bytes)];
  first = ::new (memory) Free{first};
}

void Arena::addBlock() {
  blocks_.reserve(blocks_.size() + 1);
  void* const block = mapBlock();
  // the first block has small pages: a small world does not fill it, and a large page would be allocated whole
  if (!blocks_.empty()) madvise(block, kBlock, MADV_HUGEPAGE);
  blocks_.push_back(block);
  next_ = static_cast<std::byte*>(block);
  end_ = next_ + kBlock;
}

}  // namespace pongsim::base
