#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "transport/inbox.hh"
#include "transport/input_gate.hh"
#include "transport/locks.hh"
#include "transport/services/service_server.hh"

namespace pongsim::transport {

class Interceptor;

/// What waits for `dispatch` of one `Transport`. Transports that share a bus have one each, so that each can use its
/// own thread. Exists as long as the bus.
class DispatchQueue {
 public:
  /// @return Whether nothing is waiting. Cheap.
  bool isIdle() const {
    constexpr auto kRelaxed = std::memory_order_relaxed;
    return !waiting.load(kRelaxed) && !requestsWaiting.load(kRelaxed) && !answersWaiting.load(kRelaxed);
  }

  /// A queue whose services `ownServices` lists with this one's, or null.
  const DispatchQueue* alsoLists = nullptr;

  /// Held during a dispatch; meanwhile no other thread can end a subscription or service of the queue.
  std::recursive_mutex dispatching;
  std::vector<Arrival> arrivals GUARDED_BY(dispatchingRole);
  bool inDispatch GUARDED_BY(dispatchingRole) = false;
  /// Ended within `dispatch`, and kept until it returns.
  std::vector<Inbox*> endedInboxes GUARDED_BY(dispatchingRole);
  std::vector<std::unique_ptr<Offer>> endedOffers GUARDED_BY(dispatchingRole);
  /// Requests with this number or above wait, unless systems of this transport make them: a `Gate` holds them.
  std::uint64_t requestLimit GUARDED_BY(dispatchingRole) = std::numeric_limits<std::uint64_t>::max();
  /// Who takes the message that is handed over, or null.
  Interceptor* interceptor GUARDED_BY(dispatchingRole) = nullptr;
  /// What a called function has thrown; `dispatch` throws it when it has called the others.
  std::exception_ptr failure GUARDED_BY(dispatchingRole);
  /// Notes or replaces what comes from outside; null for most runs.
  InputGate* gate GUARDED_BY(dispatchingRole) = nullptr;
  bool replaces() const REQUIRES(dispatchingRole) { return gate != nullptr && gate->use() == InputGate::Use::kReplace; }

  /// Calls a function of a subscription, service or request. Notes what it throws: the first exception in `failure`,
  /// others in the log.
  template <class Call>
  void attempt(const Call& call) REQUIRES(dispatchingRole) {
    try {
      call();
    } catch (...) {
      note(std::current_exception());
    }
  }

  /// The dispatching thread.
  std::atomic<std::thread::id> dispatcher;

  std::vector<Inbox*> inboxesWithArrivals GUARDED_BY(waitingRole);
  /// Subscriptions at once that ended within their own function; `dispatch` removes them.
  std::vector<Inbox*> endedWhileHearing GUARDED_BY(waitingRole);
  /// Topic and type of publishers found in other processes, where a subscription takes any type.
  std::vector<std::pair<std::string, std::string>> foundTypes GUARDED_BY(waitingRole);
  bool woken GUARDED_BY(waitingRole) = false;
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
  void note(std::exception_ptr thrown) REQUIRES(dispatchingRole);
};

}  // namespace pongsim::transport
