#pragma once

namespace pongsim::test {

/// While it exists, this program can start only so many more threads: pthread_create then fails as it does where the
/// system has no more (EAGAIN).
class ThreadLimit {
 public:
  explicit ThreadLimit(int more);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
};

}  // namespace pongsim::test
