#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "transport/inbox.hh"
#include "transport/service_server.hh"

namespace pongsim::transport {

/// What waits for the `dispatch` of one `Transport`. Those that share a bus have one each, so that each may be for a
/// thread of its own. Lives as long as the bus.
class DispatchQueue {
 public:
  /// @return Whether there is nothing to hand over. Cheap.
  bool isIdle() const {
    constexpr auto kRelaxed = std::memory_order_relaxed;
    return !waiting.load(kRelaxed) && !requestsWaiting.load(kRelaxed) && !answersWaiting.load(kRelaxed);
  }

  /// One dispatch at a time, and no subscription or service of the queue ends during another thread's; taken before
  /// the bus's mutexes. It guards these.
  std::recursive_mutex dispatching;
  std::vector<Arrival> arrivals;
  bool inDispatch = false;
  /// Ended by a function that `dispatch` called, for which they must stay until it returns.
  std::vector<Inbox*> endedInboxes;
  std::vector<std::unique_ptr<Offer>> endedOffers;

  /// Who dispatches now.
  std::atomic<std::thread::id> dispatcher;

  /// Guarded by the bus's mutex.
  std::vector<Inbox*> inboxesWithArrivals;
  bool woken = false;
  std::condition_variable arrived;

  /// Whether there may be messages, requests, and answers to requests of this queue that another one's service gave.
  std::atomic<bool> waiting = false;
  std::atomic<bool> requestsWaiting = false;
  std::atomic<bool> answersWaiting = false;
  /// Numbers of the requests with such answers; guarded by the client's mutex.
  std::vector<std::uint64_t> answeredRequests;

  /// Another number when a publisher or a subscription of this queue's transport has come or gone.
  std::atomic<std::uint64_t> ownTopicsVersion = 0;
};

}  // namespace pongsim::transport
