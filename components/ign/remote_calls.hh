#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "ign/generation.hh"
#include "pongsim/node.hh"

namespace pongsim::ign {

/// Calls of the world to services of other processes on ign-transport. For any thread.
class RemoteCalls {
 public:
  explicit RemoteCalls(Generation generation);

  /// See `CallElsewhere`.
  std::optional<CallResult> call(const std::string& service, const Message& request, Message& reply,
                                 std::chrono::nanoseconds timeout);

  /// Ends the waits of all calls.
  void end();

 private:
  class Request;
  /// Shared with requests, because the library's thread may use it after this object has been destroyed.
  struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    bool hasEnded = false;
  };

  const Generation generation_;
  const std::string nodeUuid_;
  const std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};

}  // namespace pongsim::ign
