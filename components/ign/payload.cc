#include "ign/payload.hh"

#include <atomic>
#include <cstdlib>
#include <new>

namespace pongsim::ign {

namespace {

// The size is stored before the bytes, which keep malloc's alignment.
constexpr std::size_t kHead = alignof(std::max_align_t);

std::atomic<std::size_t>& totalBytes() {
  static std::atomic<std::size_t> total = 0;
  return total;
}

}  // namespace

Payload::Payload(std::size_t size) : data_(nullptr), size_(size) {
  auto* block = static_cast<std::byte*>(std::malloc(kHead + size));
  if (block == nullptr) throw std::bad_alloc();
  new (block) std::size_t(size);
  data_ = block + kHead;
  totalBytes() += size;
}

void Payload::free(void* data, void*) {
  if (data == nullptr) return;
  std::byte* block = static_cast<std::byte*>(data) - kHead;
  totalBytes() -= *std::launder(reinterpret_cast<std::size_t*>(block));
  std::free(block);
}

std::size_t Payload::total() { return totalBytes(); }

}  // namespace pongsim::ign
