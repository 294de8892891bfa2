#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "pongsim/node.hh"

namespace pongsim::ign {

/// Calls of the world to services that nodes of ign-transport offer. For any thread.
class RemoteCalls {
 public:
  RemoteCalls();

  /// As `CallElsewhere`.
  std::optional<CallResult> call(const std::string& service, const Message& request, Message& reply,
                                 std::chrono::nanoseconds timeout);

  /// Lets go of who waits.
  void end();

 private:
  class Request;
  /// What the library's thread may come to after all else has gone.
  struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    bool hasEnded = false;
  };

  const std::string nodeUuid_;
  const std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};

}  // namespace pongsim::ign
