#include "transport/inbox.hh"

#include <algorithm>
#include <utility>

#include "msgs/bytes.hh"

namespace pongsim::transport {

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
