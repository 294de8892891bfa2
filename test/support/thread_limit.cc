#include "support/thread_limit.hh"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <climits>

namespace pongsim::test {

namespace {
std::atomic<int> threadsLeft = INT_MAX;
}  // namespace

ThreadLimit::ThreadLimit(int more) { threadsLeft = more; }
ThreadLimit::~ThreadLimit() { threadsLeft = INT_MAX; }

}  // namespace pongsim::test

// Takes the place of the C library's in programs that link this file.
extern "C" __attribute__((visibility("default"))) int pthread_create(pthread_t* thread,
                                                                     const pthread_attr_t* attributes,
                                                                     void* (*work)(void*), void* with) noexcept {
  static const auto original = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  if (pongsim::test::threadsLeft.load() <= 0) return EAGAIN;
  --pongsim::test::threadsLeft;
  return original(thread, attributes, work, with);
}
