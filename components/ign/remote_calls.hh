#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "pongsim/node.hh"

namespace pongsim::ign {

/// Calls from the world to services offered by ign-transport nodes. For any thread.
class RemoteCalls {
 public:
  RemoteCalls();

  /// See `CallElsewhere`.
  std::optional<CallResult> call(const std::string& service, const Message& request, Message& reply,
                                 std::chrono::nanoseconds timeout);

  /// Releases the waiting callers.
  void end();

 private:
  class Request;
  /// State that the library's thread may still use after everything else has been destroyed.
  struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    bool hasEnded = false;
  };

  const std::string nodeUuid_;
  const std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};

}  // namespace pongsim::ign
