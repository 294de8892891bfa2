// The bus's subscriptions to messages of any type. DDS matches readers with writers by type, so there is a reader for
// each published type. New types are found on DDS's threads, which must not make readers; `dispatch` makes them.
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

// Bounds the readers that another process can make this one open by publishing ever new types.
constexpr std::size_t kMostTypes = 64;

const Logger& anyTypeLog() {
  static const Logger logger("transport");
  return logger;
}

}  // namespace

AnyType& Bus::addAnyType(DispatchQueue& queue, std::string_view topic, ReceivedOfAnyType received,
                         const SubscriptionOptions& options, CallGuard* guard) {
  const SetUpLock lock(setUp_);
  auto owned = std::make_unique<AnyType>();
  AnyType& any = *owned;
  any.topic = absoluteTopic(topic);
  any.queue = &queue;
  any.received = std::make_shared<const ReceivedOfAnyType>(std::move(received));
  any.options = options;
  any.guard = guard;
  // evaluated now: the publisher may have ended when the first inbox is made
  any.except = Inbox::excepted(options);
  any.options.except = nullptr;
  std::vector<std::string> types;
  try {
    if (network_) {
      // first, so that others do not take the readers of single types for ordinary ones
      any.announcement = network_->makeReader(any.topic, std::string(kAnyType), [](const ParticipantId&, Buffer&) {});
      network_->directory().addOwn({any.topic, std::string(kAnyType), Role::kSubscriber});
      any.isListed = true;
    }
    {
      const WaitingLock anyTypesLock(delivery_.mutex);
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

std::vector<AnyType*> Bus::anyTypesOn(const std::string& topic) {
  std::vector<AnyType*> found;
  const WaitingLock lock(delivery_.mutex);
  for (const auto& any : anyTypes_) {
    if (any->topic == topic) found.push_back(any.get());
  }
  return found;
}

/// @return The types of a topic's publishers, here and elsewhere.
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

std::unique_ptr<AnyType> Bus::takeAnyType(const AnyType& any) {
  const WaitingLock anyTypesLock(delivery_.mutex);
  const auto found = std::ranges::find(anyTypes_, &any, &std::unique_ptr<AnyType>::get);
  std::unique_ptr<AnyType> owned = std::move(*found);
  anyTypes_.erase(found);
  return owned;
}

void Bus::endAnnouncement(AnyType& any) {
  if (any.isListed) network_->directory().removeOwn({any.topic, std::string(kAnyType), Role::kSubscriber});
  if (any.announcement) network_->end(std::move(any.announcement));
}

void Bus::end(AnyType& any) {
  const DispatchLock dispatchLock(any.queue->dispatching);
  std::unique_ptr<AnyType> owned;
  {
    const SetUpLock lock(setUp_);
    owned = takeAnyType(any);
  }
  if (!any.options.relays) ++any.queue->ownTopicsVersion;
  for (Inbox* inbox : any.inboxesNow(delivery_)) end(*inbox);
  const SetUpLock lock(setUp_);
  endAnnouncement(any);
}

/// Makes an inbox for a type, unless there is one. Where that fails, there is a warning and nothing else: whoever
/// advertises the type does not fail, too.
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
  const std::vector<Inbox*> inboxes = any.inboxesNow(delivery_);
  const auto isOf = [&type](const Inbox* inbox) { return inbox->channel.type == type; };
  if (std::ranges::any_of(inboxes, isOf)) return;
  if (inboxes.size() >= kMostTypes) {
    if (std::exchange(any.isFull, true)) return;
    anyTypeLog().warning("topic '" + any.topic + "': more than " + std::to_string(kMostTypes) +
                         " types are published; the others are not received, '" + type + "' first");
    return;
  }
  {
    // the push_back below must not fail
    const WaitingLock inboxesLock(delivery_.mutex);
    any.inboxes.reserve(any.inboxes.size() + 1);
  }
  Inbox* added = inChannel(any.topic, type, [&](Channel& channel) REQUIRES(setUpRole) {
    auto inbox = std::make_unique<Inbox>(channel, *any.queue, any.received, any.options, any.guard);
    inbox->except = any.except;
    return &addInbox(std::move(inbox));
  });
  const WaitingLock inboxesLock(delivery_.mutex);
  any.inboxes.push_back(added);
}

/// Called by DDS.
void Bus::publisherFound(const std::string& topic, const std::string& type) {
  const WaitingLock lock(delivery_.mutex);
  for (const auto& any : anyTypes_) {
    if (any->topic != topic) continue;
    any->queue->foundTypes.emplace_back(topic, type);
    any->queue->waiting = true;
    any->queue->arrived.notify_one();
  }
}

/// Makes the inboxes of types that were found, and ends subscriptions that ended while they heard.
void Bus::hearFoundTypes(DispatchQueue& queue) {
  std::vector<std::pair<std::string, std::string>> found;
  std::vector<Inbox*> ended;
  {
    const WaitingLock lock(delivery_.mutex);
    found.swap(queue.foundTypes);
    ended.swap(queue.endedWhileHearing);
  }
  for (Inbox* inbox : ended) end(*inbox);
  if (found.empty()) return;
  const SetUpLock lock(setUp_);
  for (const auto& [topic, type] : found) {
    for (AnyType* any : anyTypesOn(topic)) {
      if (any->queue == &queue) hear(*any, type);
    }
  }
}

std::vector<Inbox*> AnyType::inboxesNow(Delivery& delivery) const {
  const WaitingLock lock(delivery.mutex);
  return inboxes;
}

}  // namespace pongsim::transport
