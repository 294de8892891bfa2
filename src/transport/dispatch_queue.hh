#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "transport/inbox.hh"
#include "transport/services/service_server.hh"

namespace pongsim::transport {

/// What waits for `dispatch` of one `Transport`. Transports that share a bus have one each, so that each can use its
/// own thread. Exists as long as the bus.
class DispatchQueue {
 public:
  /// @return Whether nothing is waiting. Cheap.
  bool isIdle() const {
    constexpr auto kRelaxed = std::memory_order_relaxed;
    return !waiting.load(kRelaxed) && !requestsWaiting.load(kRelaxed) && !answersWaiting.load(kRelaxed);
  }

  /// Held during a dispatch; meanwhile no other thread can end a subscription or service of the queue. Locked before
  /// the bus's mutexes. Guards the following members.
  std::recursive_mutex dispatching;
  std::vector<Arrival> arrivals;
  bool inDispatch = false;
  /// Ended within `dispatch`, and kept until it returns.
  std::vector<Inbox*> endedInboxes;
  std::vector<std::unique_ptr<Offer>> endedOffers;
  /// What a called function has thrown; `dispatch` throws it when it has called the others.
  std::exception_ptr failure;

  /// Calls a function of a subscription, service or request. Notes what it throws: the first exception in `failure`,
  /// others in the log.
  template <class Call>
  void attempt(const Call& call) {
    try {
      call();
    } catch (...) {
      note(std::current_exception());
    }
  }

  /// The dispatching thread.
  std::atomic<std::thread::id> dispatcher;

  /// Guarded by the bus's mutex.
  std::vector<Inbox*> inboxesWithArrivals;
  /// Subscriptions at once that ended within their own function; `dispatch` removes them.
  std::vector<Inbox*> endedWhileHearing;
  bool woken = false;
  std::condition_variable arrived;

  /// Whether messages, requests, or responses from services of other queues may be waiting.
  std::atomic<bool> waiting = false;
  std::atomic<bool> requestsWaiting = false;
  std::atomic<bool> answersWaiting = false;
  /// Numbers of requests with such responses; guarded by the client's mutex.
  std::vector<std::uint64_t> answeredRequests;

  /// Changes when a publisher or subscription of this queue's transport is added or removed.
  std::atomic<std::uint64_t> ownTopicsVersion = 0;

 private:
  void note(std::exception_ptr thrown);
};

}  // namespace pongsim::transport
