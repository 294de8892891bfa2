#include "transport/channel.hh"

#include <set>
#include <utility>

#include "transport/dispatch_queue.hh"
#include "transport/inbox.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

Channel::Channel(std::string topicName, std::string typeName)
    : topic(std::move(topicName)), type(std::move(typeName)) {}

Channel::~Channel() = default;

void Channel::countPublisher(DispatchQueue& queue, const PublisherOptions& publisher, int change) {
  for (Users* each : {&users, &usersOf[&queue]}) {
    each->publishers += change;
    if (publisher.latched) each->latchedPublishers += change;
    if (publisher.relays) each->relayingPublishers += change;
    if (publisher.ownOnly) each->ownOnlyPublishers += change;
  }
  if (!publisher.relays) ++queue.ownTopicsVersion;
}

void Channel::countSubscription(const Inbox& inbox, int change) {
  (inbox.isAtOnce() ? atOnceCount : inboxCount) += change;
  if (inbox.relays) relayingCount += change;
  for (Users* each : {&users, &usersOf[inbox.queue]}) {
    each->subscriptions += change;
    if (inbox.relays) each->relayingSubscriptions += change;
    if (inbox.ownOnly) each->ownOnlySubscriptions += change;
  }
}

void Channel::countAtOnceQueues() {
  std::set<const DispatchQueue*> queues;
  for (const Inbox* inbox : atOnce) queues.insert(inbox->queue);
  atOnceQueue = queues.empty() ? nullptr : *queues.begin();
  atOnceQueues = static_cast<int>(queues.size());
}

bool Channel::needsInboxes(const DispatchQueue& queue, const PublisherOptions& publisher) const {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  if (publisher.latched || inboxCount.load(kRelaxed) > 0) return true;
  if (publisher.ownOnly) return false;
  const int queues = atOnceQueues.load(kRelaxed);
  return queues > 1 || (queues == 1 && atOnceQueue.load(kRelaxed) != &queue);
}

}  // namespace pongsim::transport
