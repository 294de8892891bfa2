#include "ros2/node/mailbox.hh"

#include <utility>

namespace pongsim::ros2 {

bool Mailbox::post(std::function<void()> call) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= most_) {
      ++dropped_;
      return false;
    }
    waiting_.push_back(std::move(call));
    isWaiting_ = true;
  }
  if (posted_) posted_();
  return true;
}

std::size_t Mailbox::dispatch() {
  if (!isWaiting_.load(std::memory_order_relaxed)) return 0;
  {
    const std::lock_guard lock(mutex_);
    std::swap(waiting_, taken_);
    isWaiting_ = false;
  }
  const std::size_t count = taken_.size();
  for (const auto& call : taken_) call();
  taken_.clear();
  return count;
}

}  // namespace pongsim::ros2
