#include "ros2/wire/outbox.hh"

#include <sched.h>

#include <algorithm>

namespace pongsim::ros2 {

Outbox::Outbox() : thread_([this] { run(); }) {}

Outbox::~Outbox() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  added_.notify_one();
  thread_.join();
}

void Outbox::add(Target& target, Buffer* buffer, const SampleId& related) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({&target, buffer, related});
    if (++target.waiting_ > target.mostWaiting()) dropOldestOf(target);
  }
  added_.notify_one();
}

void Outbox::dropOldestOf(const Target& target) {
  const auto oldest = std::ranges::find(waiting_, &target, &Entry::target);
  buffers_.giveBack(oldest->buffer);
  --oldest->target->waiting_;
  ++oldest->target->dropped_;
  waiting_.erase(oldest);
}

void Outbox::flush(Target& target) {
  std::unique_lock lock(mutex_);
  sent_.wait(lock, [&target] { return target.waiting_ == 0 && !target.isSending_; });
}

void Outbox::run() {
  // so that it does not preempt the simulation's thread
  constexpr sched_param kNoPriority{};
  sched_setscheduler(0, SCHED_BATCH, &kNoPriority);
  std::unique_lock lock(mutex_);
  while (true) {
    added_.wait(lock, [this] { return isOver_ || !waiting_.empty(); });
    if (isOver_) return;
    const Entry entry = waiting_.front();
    waiting_.pop_front();
    --entry.target->waiting_;
    entry.target->isSending_ = true;
    lock.unlock();
    entry.target->send(entry.buffer, entry.related);
    lock.lock();
    entry.target->isSending_ = false;
    if (entry.target->waiting_ == 0) sent_.notify_all();
  }
}

}  // namespace pongsim::ros2
