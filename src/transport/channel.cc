#include "transport/channel.hh"

#include <algorithm>
#include <utility>

#include "transport/dispatch_queue.hh"
#include "transport/inbox.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

Channel::Channel(std::string topicName, std::string typeName, SpareParcels& unused)
    : topic(std::move(topicName)), type(std::move(typeName)), spare(unused) {}

Channel::~Channel() = default;

void Channel::countPublisher(DispatchQueue& queue, const PublisherOptions& publisher, int change) {
  // first, since it may throw
  Users& usersOfQueue = usersOf[&queue];
  for (Users* each : {&users, &usersOfQueue}) {
    each->publishers += change;
    if (publisher.latched) each->latchedPublishers += change;
    if (publisher.relays) each->relayingPublishers += change;
    if (publisher.ownOnly) each->ownOnlyPublishers += change;
  }
  if (!publisher.relays) ++queue.ownTopicsVersion;
}

void Channel::countSubscription(const Inbox& inbox, int change) {
  // first, since it may throw
  Users& usersOfQueue = usersOf[&inbox.queue];
  (inbox.isAtOnce() ? atOnceCount : inboxCount) += change;
  if (inbox.relays) relayingCount += change;
  for (Users* each : {&users, &usersOfQueue}) {
    each->subscriptions += change;
    if (inbox.relays) each->relayingSubscriptions += change;
    if (inbox.ownOnly) each->ownOnlySubscriptions += change;
  }
}

void Channel::countAtOnceQueues() {
  const DispatchQueue* const first = atOnce.empty() ? nullptr : &atOnce.front()->queue;
  atOnceQueue = first;
  isAtOnceInSeveral = std::ranges::any_of(atOnce, [first](const Inbox* inbox) { return &inbox->queue != first; });
}

bool Channel::needsInboxes(const DispatchQueue& queue, const PublisherOptions& publisher) const {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  if (publisher.latched || inboxCount.load(kRelaxed) > 0) return true;
  if (publisher.ownOnly) return false;
  // `isAtOnceInSeveral` before `atOnceQueue`: `countAtOnceQueues` writes them in the opposite order, so that a change
  // from several to one is never seen as the old first one alone
  if (isAtOnceInSeveral.load(std::memory_order_acquire)) return true;
  const DispatchQueue* const atOnceIn = atOnceQueue.load(kRelaxed);
  return atOnceIn != nullptr && atOnceIn != &queue;
}

}  // namespace pongsim::transport
