#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "transport/endpoint.hh"
#include "transport/inbox.hh"

namespace pongsim::transport {

/// A subscription to messages of any type: an inbox for each type that somebody publishes on its topic.
class AnyType {
 public:
  std::string topic;
  DispatchQueue* queue = nullptr;
  std::shared_ptr<const ReceivedOfAnyType> received;
  SubscriptionOptions options;
  /// The publisher that it does not hear, or null.
  const void* except = nullptr;

  /// One a type, guarded by the bus's mutex and changed with its set-up mutex held, too.
  std::vector<Inbox*> inboxes;
  /// Whether a type more than it takes has been complained of.
  bool isFull = false;

  /// Tells others that it is there, whatever they publish; hears nothing itself. Null without a network.
  std::unique_ptr<Reader> announcement;
};

}  // namespace pongsim::transport
