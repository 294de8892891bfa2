#include "transport/bus.hh"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "msgs/encoding/bytes.hh"
#include "pongsim/log.hh"
#include "transport/any_type.hh"
#include "transport/interceptor.hh"
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
          network_.get(), [this](DispatchQueue& queue) { delivery_.notify(queue); },
          [this](const DispatchQueue& queue, std::uint64_t call, const auto& header, auto message)
              REQUIRES(dispatchingRole) { client_.answerOwn(queue, call, header, message); }),
      client_(network_.get(), server_, [this](DispatchQueue& queue) { delivery_.notify(queue); }) {
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
  const SetUpLock lock(setUp_);
  auto& queue = queues_.emplace_back(std::make_unique<DispatchQueue>());
  // the services of the bus's own transport exist once, and the first one that shares the bus shows them to others
  if (queues_.size() == 2) queue->alsoLists = queues_.front().get();
  return *queue;
}

/// Ends what no publisher or subscription of the channel needs any more, and the channel if it has none.
void Bus::endUnused(Channel& channel) {
  const Channel::Users& users = channel.users;
  if (channel.writer && users.publishers == users.ownOnlyPublishers) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kPublisher});
    network_->end(std::move(channel.writer));
  }
  if (channel.reader && users.subscriptions == users.ownOnlySubscriptions) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kSubscriber});
    network_->end(std::move(channel.reader));
    // without a reader nobody notices when another process's latched message is replaced
    delivery_.forgetLatched(channel, [](const ParticipantId& sender) { return sender != kThisProcess; });
  }
  if (users.publishers + users.subscriptions == 0) channels_.erase({channel.topic, channel.type});
}

std::unique_ptr<PublisherState> Bus::addPublisher(DispatchQueue& queue, std::string_view topic, const std::string& type,
                                                  const PublisherOptions& options, const CallGuard* guard) {
  if (options.relays && options.latched) throw std::invalid_argument("a relaying publisher can't be latched");
  const SetUpLock lock(setUp_);
  // first, since it may throw
  const std::vector<AnyType*> anyTypes = anyTypesOn(absoluteTopic(topic));
  auto added = inChannel(topic, type, [&](Channel& channel) REQUIRES(setUpRole) {
    if (network_ && !channel.writer && !options.ownOnly) {
      channel.writer = network_->makeWriter(channel.topic, channel.type, [this] { delivery_.subscribersChanged(); });
      network_->directory().addOwn({channel.topic, channel.type, Role::kPublisher});
    }
    Writer* const writer = options.ownOnly ? nullptr : channel.writer.get();
    std::unique_ptr<PublisherState> publisher(new PublisherState{*this, queue, channel, writer, options, guard});
    channel.countPublisher(queue, options, 1);
    return publisher;
  });
  for (AnyType* any : anyTypes) hear(*any, type);
  return added;
}

void Bus::end(PublisherState& publisher) {
  const SetUpLock lock(setUp_);
  Channel& channel = publisher.channel;
  channel.countPublisher(publisher.queue, publisher.options, -1);
  if (publisher.options.latched && channel.users.latchedPublishers == 0) {
    delivery_.forgetLatched(channel, [](const ParticipantId& sender) { return sender == kThisProcess; });
    if (channel.writer) channel.writer->forgetKept();
  }
  endUnused(channel);
}

Inbox& Bus::addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                            Inbox::Function function, const SubscriptionOptions& options, CallGuard* guard) {
  const SetUpLock lock(setUp_);
  return *inChannel(topic, type, [&](Channel& channel) REQUIRES(setUpRole) {
    return &addInbox(std::make_unique<Inbox>(channel, queue, std::move(function), options, guard));
  });
}

Inbox& Bus::addInbox(std::unique_ptr<Inbox> owned) {
  Channel& channel = owned->channel;
  if (owned->isAtOnce()) {
    // the push_back below must not fail
    const Hearing hearing(channel);
    channel.atOnce.reserve(channel.atOnce.size() + 1);
  }
  Inbox& inbox = delivery_.add(std::move(owned));
  try {
    if (!inbox.ownOnly) openReader(channel);
  } catch (...) {
    delivery_.undoAdd(inbox);
    throw;
  }
  ++channel.inboxesSoFar;
  if (!inbox.ownOnly && channel.reader) {
    inbox.reader = channel.reader.get();
    inbox.lostBefore = inbox.reader->lost();
  }
  if (!inbox.relays) ++inbox.queue.ownTopicsVersion;
  if (inbox.isAtOnce()) {
    const Hearing hearing(channel);
    channel.atOnce.push_back(&inbox);
    channel.countAtOnceQueues();
  }
  delivery_.subscribersChanged();
  inbox.queue.arrived.notify_one();
  return inbox;
}

// After there is an inbox: a message that came before would be acknowledged, and lost.
void Bus::openReader(Channel& channel) {
  if (!network_ || channel.reader) return;
  channel.reader = network_->makeReader(
      channel.topic, channel.type,
      [this, &channel](const ParticipantId& sender, Buffer& sample) { receive(channel, sender, sample); },
      [this, &channel](const ParticipantId& gone) {
        delivery_.forgetLatched(channel, [&gone](const ParticipantId& sender) { return sender == gone; });
      });
  network_->directory().addOwn({channel.topic, channel.type, Role::kSubscriber});
}

void Bus::end(Inbox& inbox) {
  Channel& channel = inbox.channel;
  if (inbox.isAtOnce() && channel.hearer == std::this_thread::get_id()) {
    // its function may be what is running, and this thread holds `hearing`, which is locked after the other mutexes
    delivery_.endLater(inbox);
    return;
  }
  const DispatchLock dispatchLock(inbox.queue.dispatching);
  const SetUpLock lock(setUp_);
  if (!inbox.relays) ++inbox.queue.ownTopicsVersion;
  if (inbox.isAtOnce()) {
    const Hearing hearing(channel);
    std::erase(channel.atOnce, &inbox);
    channel.countAtOnceQueues();
  }
  delivery_.remove(inbox);
  endUnused(channel);
}

/// Takes the sample's bytes, and leaves others for the next sample.
void Bus::receive(Channel& channel, const ParticipantId& sender, Buffer& sample) {
  const std::optional<std::span<const std::byte>> message = messageInPayload(sample.bytes);
  if (!message) {
    complain(channel, sender, "is damaged");
    return;
  }
  const bool latched = keepingOf(sample.bytes) != Keeping::kNone;
  Parcel* parcel = delivery_.take(channel, sample.capacity());
  Buffer& buffer = *parcel->bytes;
  buffer.swapBytes(sample);
  buffer.bytes = buffer.bytes.subspan(kPayloadHeader, message->size());
  parcel->sender = sender;
  delivery_.deliver(channel, parcel, latched, nullptr);
}

Offer& Bus::addService(DispatchQueue& queue, std::string_view service, std::string_view requestType,
                       std::string_view replyType, ServiceHandler handler, bool isOfWorld) {
  const SetUpLock lock(setUp_);
  return server_.add(queue, service, requestType, replyType, std::move(handler), isOfWorld);
}

void Bus::end(Offer& offer) {
  const DispatchLock dispatchLock(offer.queue.dispatching);
  const SetUpLock lock(setUp_);
  server_.end(offer, offer.queue.inDispatch);
}

std::vector<OwnTopic> Bus::ownTopics(const DispatchQueue& queue) {
  const SetUpLock lock(setUp_);
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
  const WaitingLock anyTypesLock(delivery_.mutex);
  for (const auto& any : anyTypes_) {
    if (any->queue == &queue && !any->options.relays)
      topics.push_back({any->topic, std::string(kAnyType), 0, 1, false, 0});
  }
  std::ranges::stable_sort(topics, {}, [](const OwnTopic& topic) { return std::tie(topic.name, topic.type); });
  return topics;
}

/// What has passed through each channel.
TrafficReport Bus::traffic() {
  const SetUpLock lock(setUp_);
  TrafficReport report;
  report.at = std::chrono::steady_clock::now().time_since_epoch();
  for (const auto& [key, channel] : channels_) {
    if (channel->users.publishers > channel->users.ownOnlyPublishers) {
      report.endpoints.push_back({channel->topic, channel->type, Role::kPublisher, channel->sent,
                                  channel->writer ? channel->writer->dropped() : 0});
    }
    if (channel->users.subscriptions == channel->users.ownOnlySubscriptions) continue;
    EndpointTraffic received{channel->topic, channel->type, Role::kSubscriber, 0,
                             channel->reader ? channel->reader->lost() : 0};
    const WaitingLock inboxesLock(delivery_.mutex);
    for (const Inbox* inbox : channel->inboxes) {
      received.messages += inbox->received();
      received.dropped += inbox->dropped();
    }
    report.endpoints.push_back(std::move(received));
  }
  return report;
}

/// Calls `handOver`, which returns how many messages it has handed over, and then handles requests and responses.
template <class HandOver>
std::size_t Bus::inDispatch(DispatchQueue& queue, const HandOver& handOver) {
  if (queue.inDispatch) throw std::logic_error("dispatch was called within dispatch");
  queue.inDispatch = true;
  queue.dispatcher = std::this_thread::get_id();

  // also when something throws
  struct Release {
    ~Release() REQUIRES(dispatchingRole) {
      queue.dispatcher = std::thread::id();
      delivery.release(queue);
    }
    Delivery& delivery;
    DispatchQueue& queue;
  } const release{delivery_, queue};

  hearFoundTypes(queue);
  std::size_t handedOver = handOver();
  handedOver += server_.dispatch(queue, [this](std::uint64_t call) { return !client_.isWaitedFor(call); });
  handedOver += client_.dispatch(queue);
  if (queue.failure) std::rethrow_exception(std::exchange(queue.failure, nullptr));
  return handedOver;
}

std::size_t Bus::dispatch(DispatchQueue& queue) {
  if (queue.isIdle()) return 0;
  const DispatchLock lock(queue.dispatching);
  return inDispatch(queue, [&]() REQUIRES(dispatchingRole) {
    std::size_t handedOver = 0;
    delivery_.collect(queue);
    if (queue.gate != nullptr) queue.replaces() ? replace(queue) : note(queue);
    for (const Arrival& arrival : queue.arrivals) {
      if (!arrival.inbox->ended && handOver(arrival)) ++handedOver;
    }
    if (queue.interceptor != nullptr) std::exchange(queue.interceptor, nullptr)->release();
    return handedOver;
  });
}

/// @return Whether it was a message that the subscription can use.
bool Bus::handOver(Inbox& inbox, Parcel& parcel) {
  std::optional<std::string> fault;
  inbox.queue.attempt([&] { fault = inbox.handOver(parcel); });
  if (fault) complain(inbox.channel, parcel.sender, *fault);
  return !fault;
}

bool Bus::handOver(const Arrival& arrival) {
  Inbox& inbox = *arrival.inbox;
  Interceptor* const interceptor =
      arrival.isOutside ? inbox.channel.interceptor.load(std::memory_order_relaxed) : nullptr;
  Interceptor* const before = std::exchange(inbox.queue.interceptor, interceptor);
  if (before != nullptr && before != interceptor) before->release();
  if (interceptor == nullptr || &interceptor->queue != &inbox.queue) {
    return handOver(inbox, *arrival.parcel);
  }
  bool isUsed = false;
  for (Parcel* passed : interceptor->takeIncoming(inbox.channel, *arrival.parcel)) {
    isUsed = handOver(inbox, *passed) || isUsed;
  }
  return isUsed;
}

Interceptor* Bus::interceptorOf(const std::string& topic) const {
  const auto found = std::ranges::find(interceptors_, topic, &Interceptor::topic);
  return found == interceptors_.end() ? nullptr : *found;
}

void Bus::add(Interceptor& interceptor) {
  const SetUpLock lock(setUp_);
  if (interceptorOf(interceptor.topic) != nullptr) {
    throw std::invalid_argument("topic '" + interceptor.topic + "' is already intercepted");
  }
  interceptors_.push_back(&interceptor);
  for (const auto& [key, channel] : channels_) {
    if (channel->topic == interceptor.topic) channel->interceptor = &interceptor;
  }
}

void Bus::end(Interceptor& interceptor) {
  const DispatchLock dispatchLock(interceptor.queue.dispatching);
  const SetUpLock lock(setUp_);
  std::erase(interceptors_, &interceptor);
  for (const auto& [key, channel] : channels_) {
    if (channel->interceptor == &interceptor) channel->interceptor = nullptr;
  }
  DispatchQueue& queue = interceptor.queue;
  if (queue.interceptor == &interceptor) std::exchange(queue.interceptor, nullptr)->release();
}

void Bus::sendInside(const Interceptor& interceptor, std::string_view type, std::span<const std::byte> bytes,
                     bool isCarried) {
  const SetUpLock lock(setUp_);
  const auto found = channels_.find(std::pair(interceptor.topic, std::string(type)));
  if (found == channels_.end()) return;
  Parcel* parcel = delivery_.take(*found->second, bytes.size());
  std::ranges::copy(bytes, parcel->bytes->bytes.begin());
  delivery_.deliverInside(*found->second, parcel, interceptor.queue, isCarried);
}

std::size_t Bus::serve(DispatchQueue& queue, std::uint64_t requestLimit) {
  const DispatchLock lock(queue.dispatching);
  queue.requestLimit = requestLimit;
  // held ones may be below the new limit
  queue.requestsWaiting = true;
  return inDispatch(queue, [] { return std::size_t{0}; });
}

void Bus::setRequestLimit(DispatchQueue& queue, std::uint64_t limit) {
  const DispatchLock lock(queue.dispatching);
  queue.requestLimit = limit;
  queue.requestsWaiting = true;
}

void Bus::discard(DispatchQueue& queue) {
  const DispatchLock lock(queue.dispatching);
  delivery_.discard(queue);
  server_.discard(queue, [this](std::uint64_t call) { return !client_.isWaitedFor(call); });
}

std::optional<std::string> Bus::refusal(const DispatchQueue& queue, std::string_view topic, const Message& message) {
  const SetUpLock lock(setUp_);
  const auto found = channels_.find(std::pair(absoluteTopic(topic), msgs::typeName(message)));
  if (found == channels_.end()) return std::nullopt;
  const WaitingLock inboxesLock(delivery_.mutex);
  for (const Inbox* inbox : found->second->inboxes) {
    if (&inbox->queue != &queue) continue;
    if (std::optional<std::string> reason = inbox->refusal(message)) return reason;
  }
  return std::nullopt;
}

bool Bus::isHeardOutside(const DispatchQueue& queue, std::string_view topic) {
  const SetUpLock lock(setUp_);
  for (const auto& [key, channel] : channels_) {
    const auto found = channel->usersOf.find(&queue);
    if (found == channel->usersOf.end() || (!topic.empty() && channel->topic != topic)) continue;
    const Channel::Users& own = found->second;
    if (own.publishers == own.relayingPublishers) continue;
    const bool isHeardHere = channel->users.subscriptions > own.subscriptions - own.relayingSubscriptions;
    if (isHeardHere || (channel->writer && channel->writer->hasReaders())) return true;
  }
  return false;
}

std::string Bus::publishersOutside(const DispatchQueue& queue, std::string_view topic) {
  std::string text;
  if (network_) {
    for (const auto& publisher : network_->directory().topic(std::string(topic)).publishers) {
      text += (text.empty() ? "process " : ", process ") + std::to_string(publisher.pid);
    }
  }
  if (!text.empty()) return text;
  const SetUpLock lock(setUp_);
  bool isCarried = false;
  for (const auto& [key, channel] : channels_) {
    if (channel->topic != topic) continue;
    const Channel::Users& own = channel->usersOf[&queue];
    if (channel->users.publishers > own.publishers) return "this process";
    isCarried = isCarried || own.relayingPublishers > 0;
  }
  return isCarried ? "another network" : "";
}

void Bus::complain(Channel& channel, const ParticipantId& sender, std::string_view what) {
  std::optional<std::uint64_t> unmentioned;
  {
    const WaitingLock lock(delivery_.mutex);
    unmentioned = channel.complaints.pass(std::chrono::steady_clock::now());
  }
  if (!unmentioned) return;
  const int pid = network_ ? network_->directory().pidOf(sender) : 0;
  busLog().warning("topic '" + channel.topic + "': a message from " +
                   (sender == kThisProcess ? "this process" : "process " + std::to_string(pid)) + " " +
                   std::string(what) + "; dropped" +
                   (*unmentioned > 0 ? " (and " + std::to_string(*unmentioned) + " before it)" : ""));
}

}  // namespace pongsim::transport
