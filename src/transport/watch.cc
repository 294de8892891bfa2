#include "transport/watch.hh"

#include <new>
#include <utility>

namespace pongsim::transport {

Watch::Watch(std::function<TimePoint()> look) : look_(std::move(look)), thread_([this] { run(); }) {}

Watch::~Watch() {
  {
    const Lock lock(mutex_);
    isOver_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Watch::run() {
  Lock lock(mutex_);
  while (!isOver_) {
    lock.unlock();
    TimePoint next;
    try {
      next = look_();
    } catch (const std::bad_alloc&) {
      // not as an initial value: GCC 12 loses a value assigned before a throwing call whose result replaces it
      next = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    }
    lock.lock();
    changed_.wait_until(lock, next, [this]() REQUIRES(mutex_) { return isOver_; });
  }
}

}  // namespace pongsim::transport
