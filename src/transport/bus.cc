#include "transport/bus.hh"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "msgs/encoding/bytes.hh"
#include "pongsim/log.hh"
#include "transport/any_type.hh"
#include "transport/deadline.hh"
#include "transport/names/topic_name.hh"
#include "transport/names/type_name.hh"
#include "transport/network/network.hh"
#include "transport/payload.hh"

namespace pongsim::transport {

namespace {

const Logger& busLog() {
  static const Logger logger("transport");
  return logger;
}

}  // namespace

Bus::Bus(std::unique_ptr<Network> network)
    : network_(std::move(network)),
      server_(
          network_.get(), [this](DispatchQueue& queue) { requestArrived(queue); },
          [this](const DispatchQueue& queue, std::uint64_t call, const auto& header, auto message) {
            client_.answerOwn(queue, call, header, message);
          }),
      client_(network_.get(), server_, [this](DispatchQueue& queue) { requestArrived(queue); }) {
  if (!network_) return;
  network_->reportTraffic([this] { return traffic(); });
  network_->directory().tellOfPublishers([this](const auto& topic, const auto& type) { publisherFound(topic, type); });
}

Bus::~Bus() {
  if (!network_) return;
  network_->directory().tellOfPublishers({});
  network_->reportTraffic({});
}

DispatchQueue& Bus::addQueue() {
  const std::lock_guard lock(setUp_);
  return *queues_.emplace_back(std::make_unique<DispatchQueue>());
}

std::optional<NetworkInterface> Bus::interface() const { return network_ ? network_->interface() : std::nullopt; }

Channel& Bus::channelFor(std::string_view topic, const std::string& type) {
  const std::pair name(absoluteTopic(topic), type);
  if (const auto found = channels_.find(name); found != channels_.end()) return *found->second;
  return *channels_.emplace(name, std::make_unique<Channel>(name.first, type)).first->second;
}

/// Ends what no publisher or subscription of the channel needs any more, and the channel if it has none. With the
/// set-up mutex held.
void Bus::endUnused(Channel& channel) {
  const Channel::Users& users = channel.users;
  if (channel.writer && users.publishers == users.ownOnlyPublishers) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kPublisher});
    network_->end(std::move(channel.writer));
  }
  if (channel.reader && users.subscriptions == users.ownOnlySubscriptions) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kSubscriber});
    network_->end(std::move(channel.reader));
    // from now on nobody would tell that what another process latched is out of date
    forgetLatched(channel, [](const ParticipantId& sender) { return sender != kThisProcess; });
  }
  if (users.publishers + users.subscriptions == 0) channels_.erase({channel.topic, channel.type});
}

Channel& Bus::addPublisher(DispatchQueue& queue, std::string_view topic, const std::string& type,
                           const PublisherOptions& options) {
  if (options.relays && options.latched) throw std::invalid_argument("a relaying publisher can't be latched");
  const std::lock_guard lock(setUp_);
  Channel& added = inChannel(topic, type, [&](Channel& channel) -> Channel& {
    if (network_ && !channel.writer && !options.ownOnly) {
      channel.writer = network_->makeWriter(channel.topic, channel.type, [this] { subscribersChanged(); });
      network_->directory().addOwn({channel.topic, channel.type, Role::kPublisher});
    }
    channel.countPublisher(queue, options, 1);
    return channel;
  });
  for (const auto& any : anyTypes_) {
    if (any->topic == added.topic) hear(*any, added.type);
  }
  return added;
}

void Bus::endPublisher(DispatchQueue& queue, Channel& channel, const PublisherOptions& options) {
  const std::lock_guard lock(setUp_);
  channel.countPublisher(queue, options, -1);
  if (options.latched && channel.users.latchedPublishers == 0) {
    forgetLatched(channel, [](const ParticipantId& sender) { return sender == kThisProcess; });
    if (channel.writer) channel.writer->forgetKept();
  }
  endUnused(channel);
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            Inbox::Received received, const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  return inChannel(topic, type, [&](Channel& channel) -> Inbox& {
    return addInbox(queue, channel, std::make_unique<Inbox>(channel, newMessage(type), std::move(received), options));
  });
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            Inbox::ReceivedBytes received, const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  return inChannel(topic, type, [&](Channel& channel) -> Inbox& {
    return addInbox(queue, channel, std::make_unique<Inbox>(channel, std::move(received), options));
  });
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type, HeardAtOnce heard,
                            const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  return inChannel(topic, type, [&](Channel& channel) -> Inbox& {
    Inbox::Received later = [&channel, heard](const Message& message) {
      const Hearing hearing(channel);
      heard(message, nullptr);
    };
    auto inbox = std::make_unique<Inbox>(channel, newMessage(type), std::move(later), options);
    inbox->heardAtOnce = std::move(heard);
    return addHearing(queue, channel, std::move(inbox));
  });
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            HeardBytesAtOnce heard, const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  return inChannel(topic, type, [&](Channel& channel) -> Inbox& {
    Inbox::ReceivedBytes later = [&channel, heard](std::span<const std::byte> bytes) {
      const Hearing hearing(channel);
      heard(bytes.size(), [bytes](std::span<std::byte> place) { std::ranges::copy(bytes, place.begin()); });
    };
    auto inbox = std::make_unique<Inbox>(channel, std::move(later), options);
    inbox->heardBytesAtOnce = std::move(heard);
    return addHearing(queue, channel, std::move(inbox));
  });
}

Inbox& Bus::addHearing(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> inbox) {
  {
    // before there is an inbox, which would have to go if this failed
    const std::lock_guard hearing(channel.hearing);
    channel.atOnce.reserve(channel.atOnce.size() + 1);
  }
  Inbox& added = addInbox(queue, channel, std::move(inbox));
  const std::lock_guard hearing(channel.hearing);
  channel.atOnce.push_back(&added);
  channel.countAtOnceQueues();
  return added;
}

Inbox& Bus::addInbox(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> owned) {
  Inbox& inbox = *owned;
  inbox.queue = &queue;
  bool isCounted = false;
  try {
    {
      const std::lock_guard inboxesLock(mutex_);
      inboxes_.emplace(&inbox, std::move(owned));
      channel.inboxes.push_back(&inbox);
      channel.countSubscription(inbox, 1);
      isCounted = true;
      const bool isLatched = channel.latched != nullptr && (!inbox.ownOnly || channel.latched->sender == kThisProcess);
      if (isLatched) putInto(inbox, channel.latched);
    }
    if (!inbox.ownOnly) openReader(channel);
  } catch (...) {
    const std::lock_guard inboxesLock(mutex_);
    std::erase(channel.inboxes, &inbox);
    giveBackUnread(inbox);
    if (isCounted) channel.countSubscription(inbox, -1);
    inboxes_.erase(&inbox);
    throw;
  }
  ++channel.inboxesSoFar;
  if (channel.reader) inbox.lostBefore = channel.reader->lost();
  if (!inbox.relays) ++queue.ownTopicsVersion;
  subscribersChanged_.notify_all();
  queue.arrived.notify_one();
  return inbox;
}

// Not before there is an inbox: what came at once would be acknowledged, and lost.
void Bus::openReader(Channel& channel) {
  if (!network_ || channel.reader) return;
  channel.reader = network_->makeReader(
      channel.topic, channel.type,
      [this, &channel](const ParticipantId& sender, Buffer& sample) { receive(channel, sender, sample); },
      [this, &channel](const ParticipantId& gone) {
        forgetLatched(channel, [&gone](const ParticipantId& sender) { return sender == gone; });
      });
  network_->directory().addOwn({channel.topic, channel.type, Role::kSubscriber});
}

void Bus::endSubscription(Inbox& inbox) {
  DispatchQueue& queue = *inbox.queue;
  Channel& channel = inbox.channel();
  if (inbox.isAtOnce() && channel.hearer == std::this_thread::get_id()) {
    // its function may be what is running, and this thread holds `hearing`, which is locked after the others
    const std::lock_guard lock(mutex_);
    inbox.ended = true;
    queue.endedWhileHearing.push_back(&inbox);
    queue.waiting = true;
    return;
  }
  const std::lock_guard dispatchLock(queue.dispatching);
  const std::lock_guard lock(setUp_);
  if (!inbox.relays) ++queue.ownTopicsVersion;
  if (inbox.isAtOnce()) {
    const std::lock_guard hearing(channel.hearing);
    std::erase(channel.atOnce, &inbox);
    channel.countAtOnceQueues();
  }
  {
    const std::lock_guard inboxesLock(mutex_);
    std::erase(channel.inboxes, &inbox);
    channel.countSubscription(inbox, -1);
    giveBackUnread(inbox);
    inbox.ended = true;
    if (queue.inDispatch) {
      queue.endedInboxes.push_back(&inbox);
    } else {
      inboxes_.erase(&inbox);
    }
  }
  endUnused(channel);
}

/// With the mutex held.
void Bus::giveBackUnread(Inbox& inbox) {
  std::erase(inbox.queue->inboxesWithArrivals, &inbox);
  inbox.forgetUnread([this](Buffer* buffer) { buffers_.giveBack(buffer); });
}

/// Takes the sample's bytes, and leaves as many of no meaning for the next one.
void Bus::receive(Channel& channel, const ParticipantId& sender, Buffer& sample) {
  const std::optional<std::span<const std::byte>> message = messageInPayload(sample.bytes);
  if (!message) {
    complain(channel, sender, "is damaged");
    return;
  }
  const bool latched = keepingOf(sample.bytes) != Keeping::kNone;
  Buffer* buffer = takeBuffer(sample.capacity());
  buffer->swapBytes(sample);
  buffer->bytes = buffer->bytes.subspan(kPayloadHeader, message->size());
  buffer->sender = sender;
  deliver(channel, buffer, latched, nullptr);
}

Buffer* Bus::takeBuffer(std::size_t size) {
  const std::lock_guard lock(mutex_);
  return buffers_.take(size);
}

/// @param from Null for another process.
/// @return Whether a message waits there: not where it is not meant for, or was heard at once.
bool Bus::isFor(const Inbox& inbox, const PublisherState* from) {
  if (from == nullptr) return !inbox.ownOnly;
  const bool isOwn = inbox.queue == &from->queue;
  if (!isOwn && (inbox.ownOnly || from->options.ownOnly)) return false;
  return inbox.hears(*from) && !(isOwn && inbox.isAtOnce());
}

void Bus::deliver(Channel& channel, Buffer* buffer, bool latched, const PublisherState* from) {
  DispatchQueue* first = nullptr;
  {
    const std::lock_guard lock(mutex_);
    for (Inbox* inbox : channel.inboxes) {
      if (!isFor(*inbox, from) || !inbox->wants()) continue;
      putInto(*inbox, buffer);
      if (first == nullptr) first = inbox->queue;
      if (first != inbox->queue) inbox->queue->arrived.notify_one();
    }
    if (latched) {
      if (channel.latched != nullptr) buffers_.giveBack(channel.latched);
      channel.latched = buffer;
    } else {
      buffers_.giveBack(buffer);
    }
  }
  // without the mutex, for which who wakes would wait
  if (first != nullptr) first->arrived.notify_one();
}

/// With the mutex held.
void Bus::putInto(Inbox& inbox, Buffer* buffer) {
  if (inbox.size() == 0) inbox.queue->inboxesWithArrivals.push_back(&inbox);
  inbox.add(nextArrival_++, buffer, dropped_);
  ++buffer->users;
  for (Buffer* each : dropped_) buffers_.giveBack(each);
  dropped_.clear();
  inbox.queue->waiting = true;
}

void Bus::forgetLatched(Channel& channel, const std::function<bool(const ParticipantId& sender)>& isMeant) {
  const std::lock_guard lock(mutex_);
  if (channel.latched == nullptr || !isMeant(channel.latched->sender)) return;
  buffers_.giveBack(std::exchange(channel.latched, nullptr));
}

void Bus::collectArrivals(DispatchQueue& queue) {
  const std::lock_guard lock(mutex_);
  for (Inbox* inbox : queue.inboxesWithArrivals) inbox->moveTo(queue.arrivals);
  queue.inboxesWithArrivals.clear();
  // one may have been found since they were looked at
  queue.waiting = !foundTypes_.empty();
  std::ranges::sort(queue.arrivals, {}, &Arrival::number);
}

void Bus::releaseArrivals(DispatchQueue& queue) {
  const std::lock_guard lock(mutex_);
  for (const Arrival& arrival : queue.arrivals) buffers_.giveBack(arrival.buffer);
  queue.arrivals.clear();
  for (Inbox* inbox : queue.endedInboxes) inboxes_.erase(inbox);
  queue.endedInboxes.clear();
  queue.inDispatch = false;
}

std::size_t Bus::dispatch(DispatchQueue& queue) {
  if (queue.isIdle()) return 0;
  const std::lock_guard lock(queue.dispatching);
  if (queue.inDispatch) throw std::logic_error("dispatch was called within dispatch");
  queue.inDispatch = true;
  queue.dispatcher = std::this_thread::get_id();

  // also when a called function throws
  struct Release {
    ~Release() {
      queue.dispatcher = std::thread::id();
      bus.releaseArrivals(queue);
    }
    Bus& bus;
    DispatchQueue& queue;
  } const release{*this, queue};

  std::size_t handedOver = 0;
  hearFoundTypes(queue);
  collectArrivals(queue);
  for (const Arrival& arrival : queue.arrivals) {
    Inbox& inbox = *arrival.inbox;
    if (inbox.ended) continue;
    std::optional<std::string> fault;
    queue.attempt([&] { fault = inbox.handOver(*arrival.buffer); });
    if (fault) {
      complain(inbox.channel(), arrival.buffer->sender, *fault);
    } else {
      ++handedOver;
    }
  }
  handedOver += server_.dispatch(queue);
  handedOver += client_.dispatch(queue);
  if (queue.failure) std::rethrow_exception(std::exchange(queue.failure, nullptr));
  return handedOver;
}

std::size_t Bus::dispatchFor(DispatchQueue& queue, std::chrono::nanoseconds timeout) {
  {
    std::unique_lock lock(mutex_);
    queue.arrived.wait_until(lock, deadlineAfter(timeout), [&queue] { return queue.woken || !queue.isIdle(); });
    queue.woken = false;
  }
  return dispatch(queue);
}

void Bus::wake(DispatchQueue& queue) {
  {
    const std::lock_guard lock(mutex_);
    queue.woken = true;
  }
  queue.arrived.notify_one();
}

void Bus::complain(Channel& channel, const ParticipantId& sender, std::string_view what) {
  std::optional<std::uint64_t> unmentioned;
  {
    const std::lock_guard lock(mutex_);
    unmentioned = channel.complaints.pass(std::chrono::steady_clock::now());
  }
  if (!unmentioned) return;
  const int pid = network_ ? network_->directory().pidOf(sender) : 0;
  busLog().warning("topic '" + channel.topic + "': a message from " +
                   (sender == kThisProcess ? "this process" : "process " + std::to_string(pid)) + " " +
                   std::string(what) + "; dropped" +
                   (*unmentioned > 0 ? " (and " + std::to_string(*unmentioned) + " before it)" : ""));
}

void Bus::subscribersChanged() {
  // whoever is about to wait has looked either before, and waits by now, or afterwards
  { const std::lock_guard lock(mutex_); }
  subscribersChanged_.notify_all();
}

void Bus::requestArrived(DispatchQueue& queue) {
  { const std::lock_guard lock(mutex_); }
  queue.arrived.notify_one();
}

std::uint64_t Bus::received(const Inbox& inbox) const {
  const std::lock_guard lock(mutex_);
  return inbox.received();
}

std::uint64_t Bus::dropped(const Inbox& inbox) const {
  const Channel& channel = inbox.channel();
  // other subscriptions' readers come and go beside one that receives only from its own transport
  const std::uint64_t lost = !inbox.ownOnly && channel.reader ? channel.reader->lost() - inbox.lostBefore : 0;
  const std::lock_guard lock(mutex_);
  return inbox.dropped() + lost;
}

Offer& Bus::addService(DispatchQueue& queue, std::string_view service, std::string_view requestType,
                       std::string_view replyType, ServiceHandler handler) {
  const std::lock_guard lock(setUp_);
  return server_.add(queue, service, requestType, replyType, std::move(handler));
}

void Bus::endService(Offer& offer) {
  const std::lock_guard dispatchLock(offer.queue.dispatching);
  const std::lock_guard lock(setUp_);
  server_.end(offer, offer.queue.inDispatch);
}

CallResult Bus::call(DispatchQueue& queue, std::string_view service, const Message& request, Message& reply,
                     std::chrono::nanoseconds timeout) {
  if (queue.dispatcher == std::this_thread::get_id()) {
    throw std::logic_error("a service was called within dispatch, which must not wait");
  }
  return client_.call(queue, service, request, reply, deadlineAfter(timeout));
}

}  // namespace pongsim::transport
