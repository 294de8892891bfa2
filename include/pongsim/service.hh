#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/message.hh"

namespace pongsim {

namespace transport {
class GatewayState;
class RequestState;
class ServiceState;
}  // namespace transport

/// What a service made of a request.
struct ServiceAnswer {
  // implicit, so that a handler can return true or false
  ServiceAnswer(bool worked) : done(worked) {}

  /// @return That the request was not met, and why, in a line without a full stop.
  static ServiceAnswer refused(std::string reason) {
    ServiceAnswer answer(false);
    answer.reason = std::move(reason);
    return answer;
  }

  bool done;
  /// Why it was not, or empty.
  std::string reason;
};

/// Meets a request: fills in `reply`, which is empty at first and goes to the caller where the answer is that it is
/// done. An exception is an answer too: refused, with its text.
using ServiceHandler = std::function<ServiceAnswer(const Message& request, Message& reply)>;

enum class CallOutcome {
  /// The reply is there.
  kDone,
  /// The service answered that it did not do it.
  kRefused,
  /// No process has a service of that name.
  kNoService,
  /// There is a service of that name, with other types.
  kOtherTypes,
  /// The service did not answer in time.
  kNoAnswer,
  /// The service went away before it answered.
  kGone
};

struct CallResult {
  CallOutcome outcome = CallOutcome::kNoService;
  /// What went wrong, in a line without a full stop: "service '/x' did not answer in time". Empty where it is done.
  std::string error;

  explicit operator bool() const { return outcome == CallOutcome::kDone; }
};

/// Told what became of a request that nobody waits for. The reply is empty where the outcome is not `kDone`.
using Answered = std::function<void(const CallResult& result, const Message& reply)>;

/// A request that nobody waits for. When it is destroyed its function is not called from then on; the service gets the
/// request all the same. It must not outlive its `Transport`.
class PONGSIM_API PendingRequest {
 public:
  PendingRequest();
  explicit PendingRequest(std::unique_ptr<transport::RequestState> state);
  PendingRequest(PendingRequest&&) noexcept;
  PendingRequest& operator=(PendingRequest&&) noexcept;
  ~PendingRequest();

  explicit operator bool() const { return state_ != nullptr; }

 private:
  std::unique_ptr<transport::RequestState> state_;
};

/// A service as a transport itself offers it.
struct OwnService {
  std::string name;
  /// Full names of the message types.
  std::string requestType;
  std::string replyType;
  bool operator==(const OwnService&) const = default;
};

/// Called, by several threads at once, with a call to a service that may be elsewhere. Waits for the answer.
/// @param service With a leading slash.
/// @param reply Replaced where the outcome is `kDone`. Its type says which the service must have.
/// @return What came of it, or nothing where no such service is known.
using CallElsewhere = std::function<std::optional<CallResult>(const std::string& service, const Message& request,
                                                              Message& reply, std::chrono::nanoseconds timeout)>;

/// A way to services elsewhere, for as long as this lives. It must not outlive its `Transport`.
class PONGSIM_API Gateway {
 public:
  Gateway();
  explicit Gateway(std::unique_ptr<transport::GatewayState> state);
  Gateway(Gateway&&) noexcept;
  Gateway& operator=(Gateway&&) noexcept;
  /// Its function is not called from then on. Waits until calls of it have returned.
  ~Gateway();

  explicit operator bool() const { return state_ != nullptr; }

 private:
  std::unique_ptr<transport::GatewayState> state_;
};

/// What the processes offer under a service's name.
struct ServiceInfo {
  std::string name;
  struct Provider {
    /// Full names of the message types.
    std::string requestType;
    std::string replyType;
    /// Process that it belongs to.
    int pid = 0;
    bool operator==(const Provider&) const = default;
  };
  std::vector<Provider> providers;
};

/// A service that is offered, for as long as this lives. It must not outlive its `Transport`.
class PONGSIM_API Service {
 public:
  Service();
  explicit Service(std::unique_ptr<transport::ServiceState> state);
  Service(Service&&) noexcept;
  Service& operator=(Service&&) noexcept;
  /// Its function is not called from then on. Waits, up to half a second, for callers to get the last replies.
  ~Service();

  explicit operator bool() const { return state_ != nullptr; }

 private:
  std::unique_ptr<transport::ServiceState> state_;
};

}  // namespace pongsim
