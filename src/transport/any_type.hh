#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "transport/delivery.hh"
#include "transport/inbox.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

/// A subscription to messages of any type: it has an inbox for each type published on its topic.
class AnyType {
 public:
  std::string topic;
  DispatchQueue* queue = nullptr;
  std::shared_ptr<const ReceivedOfAnyType> received;
  SubscriptionOptions options;
  /// A publisher whose messages it ignores, or null.
  const void* except = nullptr;
  CallGuard* guard = nullptr;

  /// One per type. Changed with the set-up mutex held, too.
  std::vector<Inbox*> inboxes GUARDED_BY(waitingRole);
  std::vector<Inbox*> inboxesNow(Delivery& delivery) const;
  /// Whether a warning about too many types was given.
  bool isFull = false;

  /// Whether the directory lists the announcement.
  bool isListed = false;
  /// Announces the subscription to others, whatever they publish; receives nothing. Null without a network.
  std::unique_ptr<Reader> announcement;
};

}  // namespace pongsim::transport
