#include "ros2/wire/buffers.hh"

#include <algorithm>
#include <bit>
#include <utility>

namespace pongsim::ros2 {

namespace {
// Memory beyond this is freed instead of kept.
constexpr std::size_t kSpareBytes = 32 << 20;
// Size of the smallest buffers.
constexpr std::size_t kSmallestCapacity = 256;
}  // namespace

Buffer* Buffers::take(std::size_t size) {
  const std::size_t capacity = std::bit_ceil(std::max(size, kSmallestCapacity));
  const std::lock_guard lock(mutex_);
  std::vector<Buffer*>& free = free_[static_cast<std::size_t>(std::countr_zero(capacity))];
  Buffer* buffer = nullptr;
  if (free.empty()) {
    all_.push_back(std::make_unique<Buffer>());
    buffer = all_.back().get();
    buffer->capacity_ = capacity;
    buffer->room_ = std::make_unique_for_overwrite<std::byte[]>(capacity);
  } else {
    buffer = free.back();
    free.pop_back();
    freeBytes_ -= buffer->capacity_;
  }
  buffer->bytes = {buffer->room_.get(), size};
  return buffer;
}

void Buffers::giveBack(Buffer* buffer) {
  const std::lock_guard lock(mutex_);
  if (freeBytes_ + buffer->capacity_ <= kSpareBytes) {
    freeBytes_ += buffer->capacity_;
    free_[static_cast<std::size_t>(std::countr_zero(buffer->capacity_))].push_back(buffer);
    return;
  }
  const auto found = std::ranges::find(all_, buffer, &std::unique_ptr<Buffer>::get);
  std::swap(*found, all_.back());
  all_.pop_back();
}

}  // namespace pongsim::ros2
