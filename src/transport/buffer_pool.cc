#include "transport/buffer_pool.hh"

#include <algorithm>
#include <utility>

namespace pongsim::transport {

namespace {

// Buffers beyond this much are not kept for later.
constexpr std::size_t kSpareBytes = 32 << 20;

}  // namespace

Buffer* BufferPool::take() {
  if (free_.empty()) {
    all_.push_back(std::make_unique<Buffer>());
    all_.back()->users = 1;
    return all_.back().get();
  }
  Buffer* buffer = free_.back();
  free_.pop_back();
  freeBytes_ -= buffer->bytes.capacity();
  buffer->users = 1;
  return buffer;
}

void BufferPool::giveBack(Buffer* buffer) {
  if (--buffer->users > 0) return;
  if (freeBytes_ + buffer->bytes.capacity() <= kSpareBytes) {
    freeBytes_ += buffer->bytes.capacity();
    free_.push_back(buffer);
    return;
  }
  const auto found = std::ranges::find(all_, buffer, &std::unique_ptr<Buffer>::get);
  std::swap(*found, all_.back());
  all_.pop_back();
}

}  // namespace pongsim::transport
