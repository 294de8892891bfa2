#include "transport/channel.hh"

#include <algorithm>
#include <utility>

#include "transport/dispatch_queue.hh"
#include "transport/inbox.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

Hearing::Hearing(Channel& channel)
    : channel_(channel), lock_(channel.hearing), outer_(channel.hearer.exchange(std::this_thread::get_id())) {}

Hearing::~Hearing() { channel_.hearer = outer_; }

Channel::Channel(std::string topicName, std::string typeName)
    : topic(std::move(topicName)), type(std::move(typeName)) {}

Channel::~Channel() = default;

void Channel::countPublisher(DispatchQueue& queue, const PublisherOptions& publisher, int change) {
  // first what may fail
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
  // first what may fail
  Users& usersOfQueue = usersOf[inbox.queue];
  (inbox.isAtOnce() ? atOnceCount : inboxCount) += change;
  if (inbox.relays) relayingCount += change;
  for (Users* each : {&users, &usersOfQueue}) {
    each->subscriptions += change;
    if (inbox.relays) each->relayingSubscriptions += change;
    if (inbox.ownOnly) each->ownOnlySubscriptions += change;
  }
}

void Channel::countAtOnceQueues() {
  const DispatchQueue* const first = atOnce.empty() ? nullptr : atOnce.front()->queue;
  atOnceQueue = first;
  isAtOnceInSeveral = std::ranges::any_of(atOnce, [first](const Inbox* inbox) { return inbox->queue != first; });
}

bool Channel::needsInboxes(const DispatchQueue& queue, const PublisherOptions& publisher) const {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  if (publisher.latched || inboxCount.load(kRelaxed) > 0) return true;
  if (publisher.ownOnly) return false;
  // in this order: when the first of several has gone, the next one is there before there are no longer several
  if (isAtOnceInSeveral.load(std::memory_order_acquire)) return true;
  const DispatchQueue* const atOnceIn = atOnceQueue.load(kRelaxed);
  return atOnceIn != nullptr && atOnceIn != &queue;
}

}  // namespace pongsim::transport
