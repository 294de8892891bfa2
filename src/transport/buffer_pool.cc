#include "transport/buffer_pool.hh"

#include <algorithm>
#include <bit>
#include <utility>

namespace pongsim::transport {

namespace {

// Buffers beyond this much are not kept for later.
constexpr std::size_t kSpareBytes = 32 << 20;

// That of the smallest buffers.
constexpr std::size_t kSmallestCapacity = 256;

std::size_t capacityFor(std::size_t size) { return std::bit_ceil(std::max(size, kSmallestCapacity)); }

}  // namespace

void Buffer::resize(std::size_t size) {
  if (size > capacity_) {
    capacity_ = capacityFor(size);
    room_ = std::make_unique_for_overwrite<std::byte[]>(capacity_);
  }
  bytes = {room_.get(), size};
}

Buffer* BufferPool::take(std::size_t size) {
  std::vector<Buffer*>& free = free_[static_cast<std::size_t>(std::countr_zero(capacityFor(size)))];
  Buffer* buffer = nullptr;
  if (free.empty()) {
    all_.push_back(std::make_unique<Buffer>());
    buffer = all_.back().get();
  } else {
    buffer = free.back();
    free.pop_back();
    freeBytes_ -= buffer->capacity();
  }
  buffer->users = 1;
  buffer->resize(size);
  return buffer;
}

void BufferPool::giveBack(Buffer* buffer) {
  if (--buffer->users > 0) return;
  if (buffer->capacity() > 0 && freeBytes_ + buffer->capacity() <= kSpareBytes) {
    freeBytes_ += buffer->capacity();
    free_[static_cast<std::size_t>(std::countr_zero(buffer->capacity()))].push_back(buffer);
    return;
  }
  const auto found = std::ranges::find(all_, buffer, &std::unique_ptr<Buffer>::get);
  std::swap(*found, all_.back());
  all_.pop_back();
}

}  // namespace pongsim::transport
