#pragma once

#include <functional>
#include <list>
#include <memory>
#include <string>
#include <utility>

#include "pongsim/node.hh"

namespace pongsim::ros2 {

/// Requests to the simulation's own services, which are handled before the next step.
class Requests {
 public:
  explicit Requests(Node node) : node_(std::move(node)) {}

  /// @param answered Called with the error in one line; empty on success.
  /// @return Whether there is such a service; if not, `answered` is not called.
  bool send(const std::string& service, const Message& request, const std::string& replyType,
            std::function<void(const std::string& error)> answered) {
    const auto isDone = std::make_shared<bool>(false);
    PendingRequest pending =
        node_.request(service, request, replyType,
                      [isDone, answered = std::move(answered)](const CallResult& result, const Message&) {
                        *isDone = true;
                        if (answered) answered(result.error);
                      });
    if (!pending) return false;
    pending_.push_back({std::move(pending), isDone});
    return true;
  }

  /// Call now and then: deletes answered requests.
  void sweep() {
    pending_.remove_if([](const Pending& each) { return *each.isDone; });
  }

 private:
  struct Pending {
    PendingRequest request;
    std::shared_ptr<bool> isDone;
  };
  Node node_;
  std::list<Pending> pending_;
};

}  // namespace pongsim::ros2
