#include "transport/watch.hh"

#include <new>
#include <utility>

namespace pongsim::transport {

Watch::Watch(std::function<TimePoint()> look) : look_(std::move(look)), thread_([this] { run(); }) {}

Watch::~Watch() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Watch::run() {
  std::unique_lock lock(mutex_);
  while (!isOver_) {
    lock.unlock();
    TimePoint next;
    try {
      next = look_();
    } catch (const std::bad_alloc&) {
      // here and not before: GCC 12 loses what a variable had before a call that throws instead of setting it
      next = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    }
    lock.lock();
    changed_.wait_until(lock, next, [this] { return isOver_; });
  }
}

}  // namespace pongsim::transport
