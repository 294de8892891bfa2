#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/service.hh"
#include "transport/deadline.hh"
#include "transport/locks.hh"
#include "transport/services/gateways.hh"
#include "transport/services/service_payload.hh"

namespace pongsim::transport {

class DispatchQueue;
class Network;
class Reader;
class ServiceServer;
class Writer;

/// Calls to services of the transport itself and of other processes. Thread-safe.
class ServiceClient {
 public:
  /// @param network Null for a transport within this process.
  /// @param own The services offered by this transport.
  /// @param arrived Called on any thread when the queue has responses to dispatch.
  ServiceClient(Network* network, ServiceServer& own, std::function<void(DispatchQueue&)> arrived);
  ~ServiceClient();

  /// @param asker The caller's queue.
  CallResult call(const DispatchQueue& asker, std::string_view service, const Message& request, Message& reply,
                  TimePoint deadline);

  /// Sends a request to one of the transport's own services. `answered` is called when it has responded or ended:
  /// within `dispatch` of the asker's queue if the service belongs to another queue.
  /// @param isOwn Whether the asker's world makes it in its own step or dispatch.
  /// @return The request's number; nothing if there is no such service with these types, or too many requests are
  /// waiting.
  std::optional<std::uint64_t> post(DispatchQueue& asker, std::string_view service, const Message& request,
                                    const std::string& replyType, Answered answered, bool isOwn);

  /// Calls the functions of this queue's requests to which services of other queues have responded.
  /// @return Their number.
  std::size_t dispatch(DispatchQueue& queue) REQUIRES(dispatchingRole);
  /// @return Whether a thread waits in `call` for the response.
  bool isWaitedFor(std::uint64_t call);

  /// Cancels the call of the request's function.
  void forget(std::uint64_t request);

  /// Access to services elsewhere.
  std::uint64_t addGateway(CallElsewhere call) { return gateways_.add(std::move(call)); }
  void endGateway(std::uint64_t number) { gateways_.end(number); }

  /// Handles a response to a call of this transport's own service, of `queue`; nothing if the service has ended.
  void answerOwn(const DispatchQueue& queue, std::uint64_t call, const std::optional<ReplyHeader>& header,
                 std::span<const std::byte> message) REQUIRES(dispatchingRole);

 private:
  /// The endpoints for a service, kept for the next call.
  struct Connection {
    std::string service;
    std::string type;
    std::unique_ptr<Writer> writer;
    std::unique_ptr<Reader> reader;
  };
  /// A call that is waiting.
  struct Call {
    ParticipantId client{};
    ParticipantId server{};
    bool gone = false;
    std::optional<ReplyHeader> header;
    std::vector<std::byte> message;
  };
  /// A request sent without waiting.
  struct Posted {
    DispatchQueue* asker = nullptr;
    std::string service;
    MessagePointer reply;
    Answered answered;
    /// The response, if it waits for `dispatch`.
    std::optional<ReplyHeader> header = std::nullopt;
    std::vector<std::byte> message = {};
  };
  class CallScope;

  CallResult callOwn(const DispatchQueue& asker, const std::string& service, const Message& request, Message& reply,
                     TimePoint deadline);
  CallResult callOther(const std::string& service, const Message& request, Message& reply, TimePoint deadline);
  Connection& connectionTo(const std::string& service, const std::string& type);
  std::optional<ParticipantId> waitForServer(const Connection& connection, TimePoint deadline);
  std::string otherTypes(const Connection& connection) const;
  void receive(const Connection& connection, const ParticipantId& sender, std::span<const std::byte> payload);
  static CallResult read(const std::string& service, const std::optional<ReplyHeader>& header,
                         std::span<const std::byte> message, Message& reply);
  void changed();

  Network* network_;
  ServiceServer& own_;
  std::function<void(DispatchQueue&)> arrived_;
  Gateways gateways_;
  /// Held while endpoints are made.
  Mutex connecting_;
  std::map<std::string, std::unique_ptr<Connection>> connections_ GUARDED_BY(connecting_);

  Mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, Call> calls_ GUARDED_BY(mutex_);
  std::map<std::uint64_t, Posted> posted_ GUARDED_BY(mutex_);
  std::uint64_t nextCall_ GUARDED_BY(mutex_) = 0;
};

}  // namespace pongsim::transport
