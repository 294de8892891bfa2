#include "shared/threads/outbox.hh"

#include <algorithm>
#include <optional>

#include "pongsim/log.hh"
#include "shared/threads/scheduling.hh"

namespace pongsim::shared {

namespace {

// Taken samples are erased from the front of `waiting_` in batches of this size, because each erasure moves all others.
constexpr std::size_t kMostTaken = 10'000;

}  // namespace

Outbox::Outbox(const Limits& limits) : limits_(limits), thread_([this] { run(); }) {}

Outbox::~Outbox() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  added_.notify_one();
  thread_.join();
}

void Outbox::add(Target& target, std::size_t size, const std::function<void(std::span<std::byte>)>& fill) {
  Buffer* buffer = take(size);
  fill(buffer->bytes);

  std::optional<std::uint64_t> unmentioned;
  std::string droppedTopic;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({&target, buffer});
    waitingBytes_ += size;
    if (++target.waiting_ > target.mostWaiting()) {
      drop(takeOldest([&target](const Sample& sample) { return sample.target == &target; }));
    }
    const std::size_t count = waiting_.size() - first_;
    if (count > limits_.samples || (waitingBytes_ > limits_.bytes && count > 1)) {
      const Sample oldest = takeOldest([](const Sample& sample) { return !sample.target->isDroppedLast(); });
      unmentioned = complaints_.pass(std::chrono::steady_clock::now());
      if (unmentioned) droppedTopic = oldest.target->topic();
      drop(oldest);
    }
  }
  added_.notify_one();
  if (!unmentioned) return;
  static const Logger log("transport");
  log.warning("topic '" + droppedTopic + "': a message to other processes was dropped: more is published " +
              "than can be sent" +
              (*unmentioned > 0 ? " (and " + std::to_string(*unmentioned) + " before it, of all topics)" : ""));
}

Buffer* Outbox::take(std::size_t size) {
  const std::lock_guard lock(mutex_);
  return buffers_.take(size);
}

void Outbox::giveBack(Buffer* sample) {
  const std::lock_guard lock(mutex_);
  buffers_.giveBack(sample);
}

/// @return The oldest waiting sample for which the condition holds; the oldest of all if there is none.
template <class Condition>
Outbox::Sample Outbox::takeOldest(const Condition& condition) {
  const auto begin = waiting_.begin() + static_cast<std::ptrdiff_t>(first_);
  auto oldest = std::find_if(begin, waiting_.end(), condition);
  if (oldest == waiting_.end()) oldest = begin;
  // those before it stay in order
  std::rotate(begin, oldest, oldest + 1);
  const Sample taken = waiting_[first_++];
  waitingBytes_ -= taken.buffer->bytes.size();
  --taken.target->waiting_;
  if (first_ == waiting_.size() || first_ >= kMostTaken) {
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
  return taken;
}

void Outbox::drop(const Sample& sample) {
  ++sample.target->dropped_;
  buffers_.giveBack(sample.buffer);
  tellWhenSent(*sample.target);
}

void Outbox::tellWhenSent(const Target& target) {
  if (target.waiting_ == 0 && !target.isSending_) sent_.notify_all();
}

void Outbox::flush(Target& target) {
  std::unique_lock lock(mutex_);
  sent_.wait(lock, [&target] { return target.waiting_ == 0 && !target.isSending_; });
}

void Outbox::run() {
  const BatchScheduling scheduling;
  std::unique_lock lock(mutex_);
  while (true) {
    added_.wait(lock, [this] { return isOver_ || waiting_.size() > first_; });
    if (isOver_) return;
    const Sample sample = takeOldest([](const Sample&) { return true; });
    sample.target->isSending_ = true;
    lock.unlock();
    const bool isKept = sample.target->send(sample.buffer);
    lock.lock();
    if (!isKept) buffers_.giveBack(sample.buffer);
    sample.target->isSending_ = false;
    tellWhenSent(*sample.target);
  }
}

}  // namespace pongsim::shared
