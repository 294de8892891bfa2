#include "transport/network/outbox.hh"

#include <algorithm>
#include <optional>
#include <utility>

#include "pongsim/log.hh"
#include "transport/scheduling.hh"

namespace pongsim::transport {

namespace {

constexpr std::size_t kMostWaiting = 10'000;
constexpr std::size_t kMostWaitingBytes = 64 << 20;

}  // namespace

Outbox::Outbox() : thread_([this] { run(); }) {}

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
    ++target.pending_;
    const std::size_t count = waiting_.size() - first_;
    if (count > kMostWaiting || (waitingBytes_ > kMostWaitingBytes && count > 1)) {
      const Entry oldest = takeOldest();
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

Outbox::Entry Outbox::takeOldest() {
  const auto begin = waiting_.begin() + static_cast<std::ptrdiff_t>(first_);
  auto oldest = std::find_if(begin, waiting_.end(), [](const Entry& entry) { return !entry.target->isDroppedLast(); });
  if (oldest == waiting_.end()) oldest = begin;
  // those before it stay in order
  std::rotate(begin, oldest, oldest + 1);
  return waiting_[first_++];
}

void Outbox::drop(const Entry& entry) {
  waitingBytes_ -= entry.buffer->bytes.size();
  ++entry.target->dropped_;
  done(entry, false);
  // the dropped ones' room is used again
  if (first_ < kMostWaiting) return;
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_));
  first_ = 0;
}

void Outbox::done(const Entry& entry, bool isKept) {
  if (!isKept) buffers_.giveBack(entry.buffer);
  if (--entry.target->pending_ == 0) sent_.notify_all();
}

void Outbox::flush(Target& target) {
  std::unique_lock lock(mutex_);
  sent_.wait(lock, [&target] { return target.pending_ == 0; });
}

void Outbox::run() {
  const GivesWay givesWay;
  std::vector<Entry> taken;
  std::unique_lock lock(mutex_);
  while (true) {
    added_.wait(lock, [this] { return isOver_ || waiting_.size() > first_; });
    if (isOver_) return;
    taken.assign(waiting_.begin() + static_cast<std::ptrdiff_t>(first_), waiting_.end());
    waiting_.clear();
    first_ = 0;
    waitingBytes_ = 0;
    for (const Entry& entry : taken) {
      lock.unlock();
      const bool isKept = entry.target->send(entry.buffer);
      lock.lock();
      done(entry, isKept);
    }
  }
}

}  // namespace pongsim::transport
