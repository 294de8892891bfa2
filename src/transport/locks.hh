#pragma once

#include <mutex>

// Clang checks these annotations in the test `thread_safety`; other compilers ignore them. README.md lists the mutexes.
#if defined(__clang__)
#define PONGSIM_THREAD_SAFETY(attribute) __attribute__((attribute))
#else
#define PONGSIM_THREAD_SAFETY(attribute)
#endif
#define CAPABILITY(name) PONGSIM_THREAD_SAFETY(capability(name))
#define SCOPED_CAPABILITY PONGSIM_THREAD_SAFETY(scoped_lockable)
#define GUARDED_BY(mutex) PONGSIM_THREAD_SAFETY(guarded_by(mutex))
#define ACQUIRED_AFTER(mutex) PONGSIM_THREAD_SAFETY(acquired_after(mutex))
#define ACQUIRE(...) PONGSIM_THREAD_SAFETY(acquire_capability(__VA_ARGS__))
#define RELEASE(...) PONGSIM_THREAD_SAFETY(release_capability(__VA_ARGS__))
#define REQUIRES(...) PONGSIM_THREAD_SAFETY(requires_capability(__VA_ARGS__))

namespace pongsim::transport {

/// A std::mutex that clang knows.
class CAPABILITY("mutex") Mutex {
 private:
  friend class Lock;
  std::mutex mutex_;
};

/// Holds a mutex while it exists, but between `unlock` and `lock`.
class SCOPED_CAPABILITY Lock : public std::unique_lock<std::mutex> {
 public:
  explicit Lock(Mutex& mutex) ACQUIRE(mutex) : unique_lock(mutex.mutex_) {}
  ~Lock() RELEASE() {}
  void lock() ACQUIRE() { unique_lock::lock(); }
  void unlock() RELEASE() { unique_lock::unlock(); }
};

/// What a mutex of the bus guards in other classes, too, such as inboxes and channels: clang can't tell that their
/// mutex is the bus's, so they name one of these instead. They are not defined anywhere.
class CAPABILITY("mutex") MutexRole {};
/// `DispatchQueue::dispatching`.
extern MutexRole dispatchingRole;
/// `Bus::setUp`.
extern MutexRole setUpRole ACQUIRED_AFTER(dispatchingRole);
/// `Channel::hearing`.
extern MutexRole hearingRole ACQUIRED_AFTER(setUpRole);
/// `Delivery::mutex`.
extern MutexRole waitingRole ACQUIRED_AFTER(hearingRole);
/// `ServiceServer::mutex_`.
extern MutexRole requestsRole ACQUIRED_AFTER(setUpRole);

class SCOPED_CAPABILITY DispatchLock : public std::unique_lock<std::recursive_mutex> {
 public:
  explicit DispatchLock(std::recursive_mutex& mutex) ACQUIRE(dispatchingRole) : unique_lock(mutex) {}
  ~DispatchLock() RELEASE() {}
};
class SCOPED_CAPABILITY SetUpLock : public std::unique_lock<std::mutex> {
 public:
  explicit SetUpLock(std::mutex& mutex) ACQUIRE(setUpRole) : unique_lock(mutex) {}
  ~SetUpLock() RELEASE() {}
};
class SCOPED_CAPABILITY WaitingLock : public std::unique_lock<std::mutex> {
 public:
  explicit WaitingLock(std::mutex& mutex) ACQUIRE(waitingRole) : unique_lock(mutex) {}
  ~WaitingLock() RELEASE() {}
};
class SCOPED_CAPABILITY RequestsLock : public std::unique_lock<std::mutex> {
 public:
  explicit RequestsLock(std::mutex& mutex) ACQUIRE(requestsRole) : unique_lock(mutex) {}
  ~RequestsLock() RELEASE() {}
};

}  // namespace pongsim::transport
