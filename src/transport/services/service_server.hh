#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/service.hh"
#include "shared/threads/complaint_limit.hh"
#include "transport/deadline.hh"
#include "transport/locks.hh"
#include "transport/services/service_payload.hh"

namespace pongsim::transport {

class DispatchQueue;
class Network;
class Reader;
class Writer;

/// A service offered by this transport.
class Offer {
 public:
  Offer(DispatchQueue& place, std::string service, std::string typeOfRequest, std::string typeOfReply,
        ServiceHandler function, bool isWorlds);
  ~Offer();

  /// Where requests wait for `dispatch`.
  DispatchQueue& queue;
  const std::string name;
  const std::string requestType;
  const std::string replyType;
  const ServiceHandler handler;
  /// Whether what it answers changes the queue's world; not if it belongs to a carrier.
  const bool isOfWorld;
  MessagePointer request;
  MessagePointer reply;
  std::unique_ptr<Writer> writer;
  std::unique_ptr<Reader> reader;

  struct Request {
    /// Counted from the start, over all services.
    std::uint64_t number = 0;
    /// All zeros for a call from this transport.
    ParticipantId client{};
    std::uint64_t call = 0;
    TimePoint came;
    std::vector<std::byte> message;
    /// The queue of the world that made it in its own step or dispatch; null where it comes from outside.
    const DispatchQueue* origin = nullptr;
  };
  /// Requests waiting for `dispatch`.
  std::deque<Request> waiting GUARDED_BY(requestsRole);
  std::size_t waitingBytes GUARDED_BY(requestsRole) = 0;
  shared::ComplaintLimit complaints GUARDED_BY(requestsRole);
  std::atomic<bool> ended = false;
};

/// The services offered by a transport, or by several that share a bus. A request waits for `dispatch` of the service's
/// queue, and until the service's writer has matched the caller's reader, since an earlier reply would be lost.
///
/// Two queues may offer services of the same name. The first one handles all requests but those of the second one's own
/// queue, which gets all when the first one has ended.
class ServiceServer {
 public:
  /// Handles a response to a call within this bus, given by a service of `queue`; without a header the service has
  /// ended.
  using AnswerOwn = std::function<void(const DispatchQueue& queue, std::uint64_t call,
                                       const std::optional<ReplyHeader>&, std::span<const std::byte> message)>;
  using Arrived = std::function<void(DispatchQueue& queue)>;
  using IsInside = std::function<bool(std::uint64_t call)>;

  /// @param network Null for a transport within this process.
  /// @param arrived Called on any thread when the queue has something to dispatch.
  ServiceServer(Network* network, Arrived arrived, AnswerOwn answerOwn);
  ~ServiceServer();

  /// @throws std::invalid_argument for an invalid name, an unknown type, or a name already offered by the queue.
  Offer& add(DispatchQueue& queue, std::string_view service, std::string_view requestType, std::string_view replyType,
             ServiceHandler handler, bool isOfWorld = true) REQUIRES(setUpRole);
  /// @param inDispatch Whether `dispatch` is running.
  void end(Offer& offer, bool inDispatch) REQUIRES(dispatchingRole, setUpRole);

  /// @param asker The caller's queue.
  /// @return Request and reply type of the service that would respond, or nothing.
  std::optional<std::pair<std::string, std::string>> typesOf(const DispatchQueue& asker,
                                                             const std::string& service) const;

  /// @return The services of that queue, sorted by name.
  std::vector<OwnService> services(const DispatchQueue& queue) const;
  /// @return A number that changes when a service is added or removed.
  std::uint64_t version() const { return version_.load(std::memory_order_relaxed); }

  /// Queues a request from this bus.
  /// @param isOwn Whether the asker's world makes it in its own step or dispatch.
  /// @return False if there is no such service any more, or too many requests are waiting.
  bool post(const DispatchQueue& asker, const std::string& service, std::uint64_t call, std::vector<std::byte> message,
            bool isOwn = false);

  /// @return The number of the next request, counted over all services.
  std::uint64_t nextNumber() const { return nextNumber_.load(std::memory_order_relaxed); }

  /// @param isInside Whether a call of this bus is a system's, which no gate holds.
  std::size_t dispatch(DispatchQueue& queue, const IsInside& isInside) REQUIRES(dispatchingRole);
  /// Drops the waiting requests of this bus whose call number fulfils `isMeant`, and tells those who have posted them.
  void discard(DispatchQueue& queue, const std::function<bool(std::uint64_t call)>& isMeant) REQUIRES(dispatchingRole);

 private:
  struct Ready {
    Offer* offer;
    Offer::Request request;
  };

  // input_gate.cc
  void note(DispatchQueue& queue, const std::vector<Ready>& ready) REQUIRES(dispatchingRole);
  void replace(DispatchQueue& queue, std::vector<Ready>& ready) REQUIRES(dispatchingRole);

  void open(Offer& offer) REQUIRES(setUpRole);
  void openNext(const std::string& service) REQUIRES(setUpRole);
  std::unique_ptr<Offer> close(Offer& offer) REQUIRES(setUpRole);
  Offer* find(const DispatchQueue& asker, const std::string& service) const REQUIRES(requestsRole);
  void receive(Offer& offer, const ParticipantId& sender, std::span<const std::byte> payload);
  bool append(Offer& offer, Offer::Request request) REQUIRES(requestsRole);
  /// Leaves requests of other processes where they are if an `InputGate` replaces them.
  void takeReady(Offer& offer, const IsInside& isInside, std::vector<Ready>& ready)
      REQUIRES(dispatchingRole, requestsRole);
  void handle(Offer& offer, const Offer::Request& request);
  ServiceAnswer ask(Offer& offer);
  void answer(Offer& offer, const Offer::Request& request, const ServiceAnswer& answer);
  void complain(Offer& offer, const ParticipantId& sender, std::string_view what);
  void wake(DispatchQueue& queue);

  Network* network_;
  Arrived arrived_;
  AnswerOwn answerOwn_;

  /// Never held while a handler or DDS is called.
  mutable std::mutex mutex_;
  /// By name, in the order in which they were added.
  std::map<std::string, std::vector<std::unique_ptr<Offer>>> offers_ GUARDED_BY(requestsRole);
  /// Written with the mutex held.
  std::atomic<std::uint64_t> nextNumber_ = 0;
  std::atomic<std::uint64_t> version_ = 0;
};

}  // namespace pongsim::transport
