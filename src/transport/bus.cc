#include "transport/bus.hh"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

#include "msgs/bytes.hh"
#include "pongsim/log.hh"
#include "transport/any_type.hh"
#include "transport/deadline.hh"
#include "transport/network.hh"
#include "transport/payload.hh"
#include "transport/topic_name.hh"
#include "transport/type_name.hh"

namespace pongsim::transport {

namespace {

constexpr ParticipantId kThisProcess{};

const Logger& busLog() {
  static const Logger logger("transport");
  return logger;
}

}  // namespace

Channel::Channel(std::string topicName, std::string typeName)
    : topic(std::move(topicName)), type(std::move(typeName)) {}

Channel::~Channel() = default;

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
  auto& channel = channels_[{absoluteTopic(topic), type}];
  if (!channel) channel = std::make_unique<Channel>(absoluteTopic(topic), type);
  return *channel;
}

void Bus::eraseIfUnused(const Channel& channel) {
  if (channel.users.publishers + channel.users.subscriptions == 0) channels_.erase({channel.topic, channel.type});
}

/// Of a publisher that comes (1) or goes (-1), with the set-up mutex held.
void Bus::count(Channel& channel, DispatchQueue& queue, const PublisherOptions& publisher, int change) {
  for (Channel::Users* users : {&channel.users, &channel.usersOf[&queue]}) {
    users->publishers += change;
    if (publisher.latched) users->latchedPublishers += change;
    if (publisher.relays) users->relayingPublishers += change;
    if (publisher.ownOnly) users->ownOnlyPublishers += change;
  }
  if (!publisher.relays) ++queue.ownTopicsVersion;
}

Channel& Bus::addPublisher(DispatchQueue& queue, std::string_view topic, const std::string& type,
                           const PublisherOptions& options) {
  if (options.relays && options.latched) throw std::invalid_argument("a publisher that relays can't be latched");
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  if (network_ && !channel.writer && !options.ownOnly) {
    channel.writer = network_->makeWriter(channel.topic, channel.type, [this] { subscribersChanged(); });
    network_->directory().addOwn({channel.topic, channel.type, Role::kPublisher});
  }
  count(channel, queue, options, 1);
  for (const auto& any : anyTypes_) {
    if (any->topic == channel.topic) hear(*any, channel.type);
  }
  return channel;
}

void Bus::endPublisher(DispatchQueue& queue, Channel& channel, const PublisherOptions& options) {
  const std::lock_guard lock(setUp_);
  count(channel, queue, options, -1);
  const Channel::Users& users = channel.users;
  if (options.latched && users.latchedPublishers == 0) {
    forgetLatched(channel, [](const ParticipantId& sender) { return sender == kThisProcess; });
    if (channel.writer) channel.writer->forgetKept();
  }
  if (channel.writer && users.publishers == users.ownOnlyPublishers) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kPublisher});
    network_->end(std::move(channel.writer));
  }
  eraseIfUnused(channel);
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            Inbox::Received received, const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  return addInbox(queue, channel, std::make_unique<Inbox>(channel, newMessage(type), std::move(received), options));
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            Inbox::ReceivedBytes received, const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  return addInbox(queue, channel, std::make_unique<Inbox>(channel, std::move(received), options));
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type, HeardAtOnce heard,
                            const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  auto inbox = std::make_unique<Inbox>(
      channel, newMessage(type),
      [&channel, heard](const Message& message) {
        const std::lock_guard hearing(channel.hearing);
        heard(message, nullptr);
      },
      options);
  inbox->heardAtOnce = std::move(heard);
  return addHearing(queue, channel, std::move(inbox));
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            HeardBytesAtOnce heard, const SubscriptionOptions& options) {
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  Inbox::ReceivedBytes later = [&channel, heard](std::span<const std::byte> bytes) {
    const std::lock_guard hearing(channel.hearing);
    heard(bytes.size(), [bytes](std::span<std::byte> place) { std::copy(bytes.begin(), bytes.end(), place.begin()); });
  };
  auto inbox = std::make_unique<Inbox>(channel, std::move(later), options);
  inbox->heardBytesAtOnce = std::move(heard);
  return addHearing(queue, channel, std::move(inbox));
}

Inbox& Bus::addHearing(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> inbox) {
  Inbox& added = addInbox(queue, channel, std::move(inbox));
  const std::lock_guard hearing(channel.hearing);
  channel.atOnce.push_back(&added);
  countAtOnceQueues(channel);
  return added;
}

void Bus::countAtOnceQueues(Channel& channel) {
  std::set<const DispatchQueue*> queues;
  for (const Inbox* inbox : channel.atOnce) queues.insert(inbox->queue);
  channel.atOnceQueue = queues.empty() ? nullptr : *queues.begin();
  channel.atOnceQueues = static_cast<int>(queues.size());
}

std::vector<OwnTopic> Bus::ownTopics(const DispatchQueue& queue) {
  const std::lock_guard lock(setUp_);
  std::vector<OwnTopic> topics;
  for (const auto& [key, channel] : channels_) {
    const auto found = channel->usersOf.find(&queue);
    if (found == channel->usersOf.end()) continue;
    const Channel::Users& users = found->second;
    const int publishers = users.publishers - users.relayingPublishers;
    const int subscriptions = users.subscriptions - users.relayingSubscriptions;
    if (publishers + subscriptions == 0) continue;
    topics.push_back({channel->topic, channel->type, publishers, subscriptions, users.latchedPublishers > 0,
                      users.relayingPublishers});
  }
  for (const auto& any : anyTypes_) {
    if (any->queue == &queue && !any->options.relays)
      topics.push_back({any->topic, std::string(kAnyType), 0, 1, false, 0});
  }
  std::ranges::stable_sort(topics, {}, [](const OwnTopic& topic) { return std::tie(topic.name, topic.type); });
  return topics;
}

/// Of a subscription that comes (1) or goes (-1), with both mutexes held.
void Bus::count(Channel& channel, const Inbox& inbox, int change) {
  (inbox.isAtOnce() ? channel.atOnceCount : channel.inboxCount) += change;
  if (inbox.relays) channel.relayingCount += change;
  for (Channel::Users* users : {&channel.users, &channel.usersOf[inbox.queue]}) {
    users->subscriptions += change;
    if (inbox.relays) users->relayingSubscriptions += change;
    if (inbox.ownOnly) users->ownOnlySubscriptions += change;
  }
}

Inbox& Bus::addInbox(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> owned) {
  Inbox& inbox = *owned;
  inbox.queue = &queue;
  {
    const std::lock_guard inboxesLock(mutex_);
    inboxes_.emplace(&inbox, std::move(owned));
    channel.inboxes.push_back(&inbox);
    count(channel, inbox, 1);
    ++channel.inboxesSoFar;
    const bool isLatched = channel.latched != nullptr && (!inbox.ownOnly || channel.latched->sender == kThisProcess);
    if (isLatched) putInto(inbox, channel.latched);
  }
  try {
    if (!inbox.ownOnly) openReader(channel);
  } catch (...) {
    const std::lock_guard inboxesLock(mutex_);
    std::erase(channel.inboxes, &inbox);
    std::erase(queue.inboxesWithArrivals, &inbox);
    count(channel, inbox, -1);
    inboxes_.erase(&inbox);
    throw;
  }
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
  const std::lock_guard dispatchLock(queue.dispatching);
  const std::lock_guard lock(setUp_);
  Channel& channel = inbox.channel();
  if (!inbox.relays) ++queue.ownTopicsVersion;
  if (inbox.isAtOnce()) {
    const std::lock_guard hearing(channel.hearing);
    std::erase(channel.atOnce, &inbox);
    countAtOnceQueues(channel);
  }
  {
    const std::lock_guard inboxesLock(mutex_);
    std::erase(channel.inboxes, &inbox);
    count(channel, inbox, -1);
    std::erase(queue.inboxesWithArrivals, &inbox);
    std::vector<Arrival> unread;
    inbox.moveTo(unread);
    for (const Arrival& arrival : unread) buffers_.giveBack(arrival.buffer);
    inbox.ended = true;
    if (queue.inDispatch) {
      queue.endedInboxes.push_back(&inbox);
    } else {
      inboxes_.erase(&inbox);
    }
  }
  if (channel.reader && channel.users.subscriptions == channel.users.ownOnlySubscriptions) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kSubscriber});
    network_->end(std::move(channel.reader));
    // from now on nobody would tell that what another process latched is out of date
    forgetLatched(channel, [](const ParticipantId& sender) { return sender != kThisProcess; });
  }
  eraseIfUnused(channel);
}

bool Bus::hasSubscribers(const PublisherState& publisher) const {
  const Channel& channel = publisher.channel;
  const int here = channel.inboxCount.load(std::memory_order_relaxed) +
                   channel.atOnceCount.load(std::memory_order_relaxed) -
                   (publisher.options.relays ? channel.relayingCount.load(std::memory_order_relaxed) : 0);
  return here > 0 || (!publisher.options.ownOnly && channel.writer && channel.writer->hasReaders());
}

std::uint64_t Bus::newSubscribers(PublisherState& publisher) const {
  const Channel& channel = publisher.channel;
  const std::uint64_t soFar = channel.inboxesSoFar + (channel.writer ? channel.writer->readersSoFar() : 0);
  return soFar - std::exchange(publisher.knownSubscribers, soFar);
}

bool Bus::isAwaited(const PublisherState& publisher) const {
  return publisher.options.latched || hasSubscribers(publisher);
}

void Bus::publish(PublisherState& publisher, const Message& message) {
  const Channel& channel = publisher.channel;
  if (msgs::typeName(message) != channel.type) {
    throw std::invalid_argument("topic '" + channel.topic + "' is of " + channel.type + ", not of " +
                                msgs::typeName(message));
  }
  if (!isAwaited(publisher)) return;
  hearAtOnce(publisher, message, nullptr);
  if (!isWantedInBytes(publisher)) return;
  send(publisher, msgs::byteSize(message),
       [&message](std::span<std::byte> place) { msgs::writeBytes(message, place); });
}

void Bus::publish(PublisherState& publisher, const Message& message, const Bulk& bulk) {
  const Channel& channel = publisher.channel;
  const std::optional<msgs::BulkWriter> writer = msgs::BulkWriter::of(message, bulk);
  if (msgs::typeName(message) != channel.type || !writer) {
    throw std::invalid_argument("topic '" + channel.topic + "' is of " + channel.type + ", not of " +
                                msgs::typeName(message) + " with bytes in '" + bulk.field + "'");
  }
  if (!isAwaited(publisher)) return;
  hearAtOnce(publisher, message, &bulk);
  if (!isWantedInBytes(publisher)) return;
  send(publisher, writer->size(), [&writer](std::span<std::byte> place) { writer->write(place); });
}

/// @return Whether inboxes want it: of those who hear at once, those of other transports.
bool Bus::isForInboxes(const PublisherState& publisher) {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  const Channel& channel = publisher.channel;
  if (publisher.options.latched || channel.inboxCount.load(kRelaxed) > 0) return true;
  if (publisher.options.ownOnly) return false;
  const int queues = channel.atOnceQueues.load(kRelaxed);
  return queues > 1 || (queues == 1 && channel.atOnceQueue.load(kRelaxed) != &publisher.queue);
}

/// @return Whether others want it than those who hear at once. What these alone hear is counted as sent here.
bool Bus::isWantedInBytes(PublisherState& publisher) {
  Channel& channel = publisher.channel;
  if (isForInboxes(publisher)) return true;
  if (!publisher.options.ownOnly && channel.writer && channel.writer->hasReaders()) return true;
  ++publisher.sent;
  ++channel.sent;
  return false;
}

void Bus::hearAtOnce(PublisherState& publisher, const Message& message, const Bulk* bulk) {
  Channel& channel = publisher.channel;
  if (channel.atOnceCount.load(std::memory_order_relaxed) == 0) return;
  const std::lock_guard hearing(channel.hearing);
  // by number, for what is called may end subscriptions, or make some
  for (std::size_t i = 0; i < channel.atOnce.size(); ++i) {
    const Inbox& inbox = *channel.atOnce[i];
    if (inbox.queue != &publisher.queue || !inbox.hears(publisher)) continue;
    if (inbox.heardAtOnce) {
      inbox.heardAtOnce(message, bulk);
    } else if (bulk != nullptr) {
      const msgs::BulkWriter writer = *msgs::BulkWriter::of(message, *bulk);
      inbox.heardBytesAtOnce(writer.size(), [&writer](std::span<std::byte> place) { writer.write(place); });
    } else {
      inbox.heardBytesAtOnce(msgs::byteSize(message),
                             [&message](std::span<std::byte> place) { msgs::writeBytes(message, place); });
    }
  }
}

void Bus::hearBytesAtOnce(PublisherState& publisher, std::span<const std::byte> bytes) {
  Channel& channel = publisher.channel;
  if (channel.atOnceCount.load(std::memory_order_relaxed) == 0) return;
  const std::lock_guard hearing(channel.hearing);
  const auto copy = [bytes](std::span<std::byte> place) { std::copy(bytes.begin(), bytes.end(), place.begin()); };
  bool isRead = false;
  for (std::size_t i = 0; i < channel.atOnce.size(); ++i) {
    const Inbox& inbox = *channel.atOnce[i];
    if (inbox.queue != &publisher.queue || !inbox.hears(publisher)) continue;
    if (inbox.heardBytesAtOnce) {
      inbox.heardBytesAtOnce(bytes.size(), copy);
      continue;
    }
    if (!channel.read) channel.read = newMessage(channel.type);
    if (!isRead && !(channel.read && msgs::parseBytes(bytes, *channel.read))) {
      complain(channel, kThisProcess, "is no " + channel.type);
      return;
    }
    isRead = true;
    inbox.heardAtOnce(*channel.read, nullptr);
  }
}

void Bus::publishBytes(PublisherState& publisher, std::span<const std::byte> bytes) {
  if (!isAwaited(publisher)) return;
  hearBytesAtOnce(publisher, bytes);
  if (!isWantedInBytes(publisher)) return;
  send(publisher, bytes.size(),
       [bytes](std::span<std::byte> place) { std::copy(bytes.begin(), bytes.end(), place.begin()); });
}

void Bus::send(PublisherState& publisher, std::size_t size, const std::function<void(std::span<std::byte>)>& fill) {
  Channel& channel = publisher.channel;
  if (size > kMaximumMessage) {
    busLog().error("topic '" + channel.topic + "': a message of " + std::to_string(size) +
                   " bytes is too large to send");
    return;
  }
  ++publisher.sent;
  ++channel.sent;
  const bool latched = publisher.options.latched;
  const bool here = isForInboxes(publisher);
  const bool elsewhere = !publisher.options.ownOnly && channel.writer && (latched || channel.writer->hasReaders());
  const Keeping keeping = latched ? Keeping::kKept : Keeping::kNone;
  if (!here) {
    if (elsewhere) channel.writer->write(size, fill, keeping);
    return;
  }
  Buffer* buffer = takeBuffer(size);
  buffer->sender = kThisProcess;
  fill(buffer->bytes);
  if (elsewhere) {
    // not the one of ranges, which GCC 12 makes a loop of single bytes of
    const auto copy = [from = buffer->bytes](std::span<std::byte> place) {
      std::copy(from.begin(), from.end(), place.begin());
    };
    channel.writer->write(size, copy, keeping);
  }
  deliver(channel, buffer, latched, &publisher);
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
  ++buffer->users;
  inbox.add(nextArrival_++, buffer, dropped_);
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
  if (queue.inDispatch) throw std::logic_error("dispatch was called from a function that dispatch had called");
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
  hearFoundTypes();
  collectArrivals(queue);
  for (const Arrival& arrival : queue.arrivals) {
    Inbox& inbox = *arrival.inbox;
    if (inbox.ended) continue;
    if (const std::optional<std::string> fault = inbox.handOver(*arrival.buffer)) {
      complain(inbox.channel(), arrival.buffer->sender, *fault);
    } else {
      ++handedOver;
    }
  }
  handedOver += server_.dispatch(queue);
  return handedOver + client_.dispatch(queue);
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

bool Bus::waitForSubscribers(const PublisherState& publisher, std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  return subscribersChanged_.wait_until(lock, deadlineAfter(timeout), [&] { return hasSubscribers(publisher); });
}

bool Bus::waitForDelivery(const Channel& channel, std::chrono::nanoseconds timeout) {
  return !channel.writer || channel.writer->waitForAcknowledgement(timeout);
}

std::uint64_t Bus::received(const Inbox& inbox) const {
  const std::lock_guard lock(mutex_);
  return inbox.received();
}

std::uint64_t Bus::dropped(const Inbox& inbox) const {
  const Channel& channel = inbox.channel();
  const std::uint64_t lost = channel.reader ? channel.reader->lost() - inbox.lostBefore : 0;
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
    throw std::logic_error("a service was called from a function that dispatch had called, which must not wait");
  }
  return client_.call(queue, service, request, reply, deadlineAfter(timeout));
}

}  // namespace pongsim::transport
