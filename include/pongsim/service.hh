#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/message.hh"

namespace pongsim {

namespace transport {
class Bus;
class Offer;
class ServiceClient;
}  // namespace transport

/// The response of a service to a request.
struct ServiceAnswer {
  // implicit, so that a handler can return true or false
  ServiceAnswer(bool worked) : done(worked) {}

  /// @return A refusal with its reason, one line without a full stop.
  static ServiceAnswer refused(std::string reason) {
    ServiceAnswer answer(false);
    answer.reason = std::move(reason);
    return answer;
  }

  bool done;
  /// The reason of a refusal, or empty.
  std::string reason;
};

/// Handles a request: fills in `reply`, which is empty at first and is sent to the caller if the request was done. An
/// exception counts as a refusal with its text.
using ServiceHandler = std::function<ServiceAnswer(const Message& request, Message& reply)>;

enum class CallOutcome {
  /// The reply is there.
  kDone,
  /// The service refused the request.
  kRefused,
  /// No process has a service of that name.
  kNoService,
  /// A service with that name exists, but with other types.
  kOtherTypes,
  /// The service did not answer in time.
  kNoAnswer,
  /// The service ended before it answered.
  kGone
};

struct CallResult {
  CallOutcome outcome = CallOutcome::kNoService;
  /// What went wrong, one line without a full stop: "service '/x' did not answer in time". Empty if done.
  std::string error;

  explicit operator bool() const { return outcome == CallOutcome::kDone; }
};

/// Called with the result of a request that was sent without waiting. The reply is empty unless the outcome is `kDone`.
using Answered = std::function<void(const CallResult& result, const Message& reply)>;

/// A request that was sent without waiting. If it is destroyed, its function is not called any more; the service still
/// receives the request. Must not outlive its `Transport`.
class PONGSIM_API PendingRequest {
 public:
  PendingRequest() = default;

  explicit operator bool() const { return client_ != nullptr; }

 private:
  friend class Node;
  struct PONGSIM_API Forget {
    std::uint64_t number;
    void operator()(transport::ServiceClient* client) const;
  };

  std::unique_ptr<transport::ServiceClient, Forget> client_;
};

/// A service offered by a transport.
struct OwnService {
  std::string name;
  /// Full names of the message types.
  std::string requestType;
  std::string replyType;
  bool operator==(const OwnService&) const = default;
};

/// Handles a call to a service elsewhere, and waits for the response. Called by several threads at once.
/// @param service With a leading slash.
/// @param reply Replaced if the outcome is `kDone`. Its type selects the service's response type.
/// @return The result, or nothing if there is no such service.
using CallElsewhere = std::function<std::optional<CallResult>(const std::string& service, const Message& request,
                                                              Message& reply, std::chrono::nanoseconds timeout)>;

/// Access to services elsewhere, as long as it exists. Must not outlive its `Transport`. Its end waits until current
/// calls of its function have returned; it is not called afterwards.
class PONGSIM_API Gateway {
 public:
  Gateway() = default;

  explicit operator bool() const { return client_ != nullptr; }

 private:
  friend class Node;
  struct PONGSIM_API End {
    std::uint64_t number;
    void operator()(transport::ServiceClient* client) const;
  };

  std::unique_ptr<transport::ServiceClient, End> client_;
};

/// A service in other processes.
struct ServiceInfo {
  std::string name;
  struct Provider {
    /// Full names of the message types.
    std::string requestType;
    std::string replyType;
    /// Process id.
    int pid = 0;
    bool operator==(const Provider&) const = default;
  };
  std::vector<Provider> providers;
};

/// A service that is offered, as long as this exists. Must not outlive its `Transport`. Its end waits, up to half a
/// second, until callers have received the last replies; the function is not called afterwards.
class PONGSIM_API Service {
 public:
  Service() = default;

  explicit operator bool() const { return bus_ != nullptr; }

 private:
  friend class Node;
  struct PONGSIM_API End {
    transport::Offer* offer;
    void operator()(transport::Bus* bus) const;
  };
  Service(transport::Bus& bus, transport::Offer& offer) : bus_(&bus, {&offer}) {}

  std::unique_ptr<transport::Bus, End> bus_;
};

}  // namespace pongsim
