#include "core/crew.hh"

#include <algorithm>
#include <stdexcept>

namespace pongsim::python {

Crew::~Crew() {
  if (threads_.empty()) return;
  if (process_ != getpid()) {
    // they are another process's, and nothing of them is here to wait for
    for (std::thread& thread : threads_) thread.detach();
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  given_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::begin() {
  if (!threads_.empty() && process_ != getpid()) {
    throw std::runtime_error(
        "the threads of these environments stayed behind when the process was forked; make them in "
        "the process that steps them");
  }
  process_ = getpid();
  while (threads_.size() + 1 < wanted_) threads_.emplace_back([this] { serve(); });
}

void Crew::takeFrom(const std::function<void(std::size_t)>& work) {
  for (std::size_t i = next_++; i < count_; i = next_++) work(i);
}

void Crew::serve() {
  std::size_t seen = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    given_.wait(lock, [&] { return ends_ || round_ != seen; });
    if (ends_) return;
    seen = round_;
    const auto& work = *work_;
    lock.unlock();
    takeFrom(work);
    lock.lock();
    if (--busy_ == 0) done_.notify_one();
  }
}

void Crew::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (std::min(count, wanted_) <= 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  begin();
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    count_ = count;
    next_ = 0;
    busy_ = threads_.size();
    ++round_;
  }
  given_.notify_all();
  takeFrom(work);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return busy_ == 0; });
}

}  // namespace pongsim::python
