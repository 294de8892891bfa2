#include "transport/timer_thread.hh"

#include <new>
#include <utility>

namespace pongsim::transport {

TimerThread::TimerThread(std::function<TimePoint()> task) : task_(std::move(task)), thread_([this] { run(); }) {}

TimerThread::~TimerThread() {
  {
    const Lock lock(mutex_);
    mustEnd_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void TimerThread::run() {
  Lock lock(mutex_);
  while (!mustEnd_) {
    lock.unlock();
    TimePoint next;
    try {
      next = task_();
    } catch (const std::bad_alloc&) {
      // not as an initial value: GCC 12 loses a value assigned before a throwing call whose result replaces it
      next = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    }
    lock.lock();
    changed_.wait_until(lock, next, [this]() REQUIRES(mutex_) { return mustEnd_; });
  }
}

}  // namespace pongsim::transport
