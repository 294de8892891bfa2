#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <optional>
#include <shared_mutex>
#include <string>

#include "pongsim/service.hh"
#include "transport/deadline.hh"

namespace pongsim::transport {

/// Access to services elsewhere. Thread-safe.
class Gateways {
 public:
  /// @return A number for `end`.
  std::uint64_t add(CallElsewhere call);
  /// Waits until no call is running.
  void end(std::uint64_t number);

  /// Asks the gateways in the order in which they were added.
  /// @return The result of the call; nothing if none has such a service.
  std::optional<CallResult> call(const std::string& service, const Message& request, Message& reply,
                                 TimePoint deadline);

 private:
  /// Shared by calls.
  std::shared_mutex mutex_;
  std::map<std::uint64_t, CallElsewhere> gateways_;
  std::uint64_t next_ = 0;
  std::atomic<bool> isEmpty_ = true;
};

}  // namespace pongsim::transport
