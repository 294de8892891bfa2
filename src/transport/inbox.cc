#include "transport/inbox.hh"

#include <algorithm>
#include <utility>

#include "msgs/bytes.hh"

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

Inbox::Inbox(Channel& channel, MessagePointer message, Received received, std::size_t limit)
    : channel_(channel),
      message_(std::move(message)),
      received_(std::move(received)),
      limit_(std::max<std::size_t>(limit, 1)) {}

Inbox::~Inbox() = default;

Buffer* Inbox::add(std::uint64_t number, Buffer* buffer) {
  Buffer* oldest = nullptr;
  if (size() >= limit_) {
    oldest = waiting_[first_++].buffer;
    ++dropped_;
    // the dropped ones' room is used again before the vector grows past twice the limit
    if (first_ >= limit_) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
    }
  }
  waiting_.push_back({number, this, buffer});
  return oldest;
}

void Inbox::moveTo(std::vector<Arrival>& arrivals) {
  arrivals.insert(arrivals.end(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_), waiting_.end());
  waiting_.clear();
  first_ = 0;
}

bool Inbox::parse(const Buffer& buffer) { return msgs::parseBytes(buffer.bytes, *message_); }

}  // namespace pongsim::transport
