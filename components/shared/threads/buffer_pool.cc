#include "shared/threads/buffer_pool.hh"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <new>
#include <utility>

namespace pongsim::shared {

namespace {

// Maximum total capacity of the buffers that are kept for reuse.
constexpr std::size_t kSpareBytes = 32 << 20;

// Capacity of the smallest buffers.
constexpr std::size_t kSmallestCapacity = 256;

// Buffers of at least this capacity are mapped separately (mmap), so that freeing one returns its memory to the system.
// Freed blocks between used ones of the heap stay with the process.
constexpr std::size_t kOwnPages = 8192;

std::size_t capacityFor(std::size_t size) { return std::bit_ceil(std::max(size, kSmallestCapacity)); }

std::size_t classOf(std::size_t capacity) { return static_cast<std::size_t>(std::countr_zero(capacity)); }

std::byte* allocate(std::size_t capacity) {
  if (capacity < kOwnPages) return new std::byte[capacity];
  void* room = mmap(nullptr, capacity, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  return static_cast<std::byte*>(room);
}

}  // namespace

void FreeBytes::operator()(std::byte* bytes) const {
  if (capacity < kOwnPages) {
    delete[] bytes;
  } else {
    munmap(bytes, capacity);
  }
}

void Buffer::resize(std::size_t size) {
  if (size > capacity()) {
    const std::size_t capacity = capacityFor(size);
    room_ = {allocate(capacity), FreeBytes{capacity}};
  }
  bytes = {room_.get(), size};
}

Buffer* BufferPool::take(std::size_t size) {
  Spare& spare = spare_[classOf(capacityFor(size))];
  Buffer* buffer = nullptr;
  if (spare.buffers.empty()) {
    all_.push_back(std::make_unique<Buffer>());
    buffer = all_.back().get();
    buffer->index_ = all_.size() - 1;
  } else {
    buffer = takeFrom(spare);
  }
  buffer->users = 1;
  buffer->resize(size);
  return buffer;
}

void BufferPool::giveBack(Buffer* buffer) {
  if (--buffer->users > 0) return;
  if (buffer->capacity() > 0 && spareBytes_ + buffer->capacity() <= kSpareBytes) {
    spareBytes_ += buffer->capacity();
    spare_[classOf(buffer->capacity())].buffers.push_back(buffer);
  } else {
    free(buffer);
  }
  if (++givenBack_ % kPeriod == 0) beginPeriod();
  if (surplus_ > 0) freeOne();
}

void BufferPool::beginPeriod() {
  surplus_ = 0;
  for (Spare& spare : spare_) {
    spare.surplus = (spare.least + 1) / 2;
    spare.least = spare.buffers.size();
    surplus_ += spare.surplus;
  }
}

/// One at a time, because freeing a thousand at once would delay the caller.
void BufferPool::freeOne() {
  Spare& spare = *std::ranges::find_if(spare_, [](const Spare& each) { return each.surplus > 0; });
  --spare.surplus;
  --surplus_;
  if (!spare.buffers.empty()) free(takeFrom(spare));
}

Buffer* BufferPool::takeFrom(Spare& spare) {
  Buffer* buffer = spare.buffers.back();
  spare.buffers.pop_back();
  spare.least = std::min(spare.least, spare.buffers.size());
  spareBytes_ -= buffer->capacity();
  return buffer;
}

void BufferPool::free(Buffer* buffer) {
  const std::size_t index = buffer->index_;
  std::swap(all_[index], all_.back());
  all_[index]->index_ = index;
  all_.pop_back();
}

}  // namespace pongsim::shared
