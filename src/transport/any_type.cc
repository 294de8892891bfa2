// How the bus hears messages of any type on a topic. DDS matches readers with writers by type, so that there is a
// reader for each type that somebody writes. DDS's threads tell of writers, and must not make readers: `dispatch` does.
#include "transport/any_type.hh"

#include <algorithm>
#include <exception>
#include <utility>

#include "pongsim/log.hh"
#include "transport/bus.hh"
#include "transport/names/topic_name.hh"
#include "transport/names/type_name.hh"
#include "transport/network/network.hh"

namespace pongsim::transport {

namespace {

// A process that publishes ever new types must not make this one open readers without end.
constexpr std::size_t kMostTypes = 64;

const Logger& anyTypeLog() {
  static const Logger logger("transport");
  return logger;
}

}  // namespace

AnyType& Bus::addAnyType(DispatchQueue& queue, std::string_view topic, ReceivedOfAnyType received,
                         const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  auto owned = std::make_unique<AnyType>();
  AnyType& any = *owned;
  any.topic = absoluteTopic(topic);
  any.queue = &queue;
  any.received = std::make_shared<const ReceivedOfAnyType>(std::move(received));
  any.options = options;
  // now, for the publisher may have gone when the first inbox is made
  any.except = Inbox::excepted(options);
  any.options.except = nullptr;
  std::vector<std::string> types;
  try {
    if (network_) {
      // before the readers of types, so that others know that these are not all it takes
      any.announcement = network_->makeReader(any.topic, std::string(kAnyType), [](const ParticipantId&, Buffer&) {});
      network_->directory().addOwn({any.topic, std::string(kAnyType), Role::kSubscriber});
      any.isListed = true;
    }
    {
      const std::lock_guard anyTypesLock(mutex_);
      anyTypes_.push_back(std::move(owned));
    }
    types = typesOn(any.topic);
  } catch (...) {
    if (!owned) owned = takeAnyType(any);
    endAnnouncement(any);
    throw;
  }
  if (!options.relays) ++queue.ownTopicsVersion;
  for (const std::string& type : types) hear(any, type);
  return any;
}

/// @return The types of a topic's publishers, here and elsewhere. With the set-up mutex held.
std::vector<std::string> Bus::typesOn(const std::string& topic) const {
  std::vector<std::string> types;
  for (const auto& [key, channel] : channels_) {
    if (channel->topic == topic && channel->users.publishers > 0) types.push_back(channel->type);
  }
  if (network_) {
    for (const auto& publisher : network_->directory().topic(topic).publishers) types.push_back(publisher.type);
  }
  return types;
}

/// With the set-up mutex held.
std::unique_ptr<AnyType> Bus::takeAnyType(const AnyType& any) {
  const std::lock_guard anyTypesLock(mutex_);
  const auto found = std::ranges::find(anyTypes_, &any, &std::unique_ptr<AnyType>::get);
  std::unique_ptr<AnyType> owned = std::move(*found);
  anyTypes_.erase(found);
  return owned;
}

/// With the set-up mutex held.
void Bus::endAnnouncement(AnyType& any) {
  if (any.isListed) network_->directory().removeOwn({any.topic, std::string(kAnyType), Role::kSubscriber});
  if (any.announcement) network_->end(std::move(any.announcement));
}

void Bus::endAnyType(AnyType& any) {
  const std::lock_guard dispatchLock(any.queue->dispatching);
  std::unique_ptr<AnyType> owned;
  {
    const std::lock_guard lock(setUp_);
    owned = takeAnyType(any);
  }
  if (!any.options.relays) ++any.queue->ownTopicsVersion;
  for (Inbox* inbox : any.inboxes) endSubscription(*inbox);
  const std::lock_guard lock(setUp_);
  endAnnouncement(any);
}

/// Makes an inbox for a type, unless there is one. Where that fails, there is a warning and nothing else: whoever
/// advertises the type does not fail, too. With the set-up mutex held.
void Bus::hear(AnyType& any, const std::string& type) noexcept {
  try {
    addInboxOf(any, type);
  } catch (const std::exception& error) {
    try {
      anyTypeLog().warning("topic '" + any.topic + "': messages of '" + type + "' are not received: " + error.what());
    } catch (const std::exception&) {
      // no memory for the warning either
    }
  }
}

void Bus::addInboxOf(AnyType& any, const std::string& type) {
  if (type == kAnyType) return;
  const auto isOf = [&type](const Inbox* inbox) { return inbox->channel().type == type; };
  if (std::ranges::any_of(any.inboxes, isOf)) return;
  if (any.inboxes.size() >= kMostTypes) {
    if (std::exchange(any.isFull, true)) return;
    anyTypeLog().warning("topic '" + any.topic + "': more than " + std::to_string(kMostTypes) +
                         " types are published; the others are not received, '" + type + "' first");
    return;
  }
  {
    // before there is an inbox, which would have to go if this failed
    const std::lock_guard inboxesLock(mutex_);
    any.inboxes.reserve(any.inboxes.size() + 1);
  }
  Inbox& added = inChannel(any.topic, type, [&](Channel& channel) -> Inbox& {
    Inbox::ReceivedBytes received = [call = any.received, type](auto bytes) { (*call)(type, bytes); };
    auto inbox = std::make_unique<Inbox>(channel, std::move(received), any.options);
    inbox->except = any.except;
    return addInbox(*any.queue, channel, std::move(inbox));
  });
  const std::lock_guard inboxesLock(mutex_);
  any.inboxes.push_back(&added);
}

/// Called by DDS.
void Bus::publisherFound(const std::string& topic, const std::string& type) {
  const std::lock_guard lock(mutex_);
  bool isMeant = false;
  for (const auto& any : anyTypes_) {
    if (any->topic != topic) continue;
    isMeant = true;
    any->queue->waiting = true;
    any->queue->arrived.notify_one();
  }
  if (isMeant) foundTypes_.emplace_back(topic, type);
}

void Bus::hearFoundTypes(DispatchQueue& queue) {
  std::vector<std::pair<std::string, std::string>> found;
  std::vector<Inbox*> ended;
  {
    const std::lock_guard foundLock(mutex_);
    found.swap(foundTypes_);
    ended.swap(queue.endedWhileHearing);
  }
  for (Inbox* inbox : ended) endSubscription(*inbox);
  if (found.empty()) return;
  const std::lock_guard lock(setUp_);
  for (const auto& [topic, type] : found) {
    for (const auto& any : anyTypes_) {
      if (any->topic == topic) hear(*any, type);
    }
  }
}

std::uint64_t Bus::received(const AnyType& any) const {
  const std::lock_guard lock(mutex_);
  std::uint64_t sum = 0;
  for (const Inbox* inbox : any.inboxes) sum += inbox->received();
  return sum;
}

std::uint64_t Bus::dropped(const AnyType& any) const {
  std::vector<Inbox*> inboxes;
  {
    const std::lock_guard lock(mutex_);
    inboxes = any.inboxes;
  }
  std::uint64_t sum = 0;
  for (const Inbox* inbox : inboxes) sum += dropped(*inbox);
  return sum;
}

SubscriptionState::~SubscriptionState() {
  if (AnyType** any = std::get_if<AnyType*>(&place_)) {
    bus_.endAnyType(**any);
  } else {
    bus_.endSubscription(*std::get<Inbox*>(place_));
  }
}

std::uint64_t SubscriptionState::received() const {
  return std::visit([this](const auto* place) { return bus_.received(*place); }, place_);
}

std::uint64_t SubscriptionState::dropped() const {
  return std::visit([this](const auto* place) { return bus_.dropped(*place); }, place_);
}

}  // namespace pongsim::transport
