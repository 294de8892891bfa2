#include "transport/bus.hh"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "msgs/bytes.hh"
#include "pongsim/log.hh"
#include "transport/deadline.hh"
#include "transport/network.hh"
#include "transport/payload.hh"
#include "transport/service_name.hh"
#include "transport/topic_name.hh"

namespace pongsim::transport {

namespace {

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
          network_.get(), [this] { requestArrived(); },
          [this](std::uint64_t call, const auto& header, auto message) { client_.answerOwn(call, header, message); }),
      client_(network_.get(), server_) {}

Bus::~Bus() = default;

Channel& Bus::channelFor(std::string_view topic, std::string_view type) {
  const std::optional<std::string> typeName = messageTypeName(type);
  if (!typeName) {
    const std::string nearest = nearestMessageType(type);
    throw std::invalid_argument("there is no message type '" + std::string(type) + "'" +
                                (nearest.empty() ? "" : ", did you mean '" + nearest + "'?"));
  }
  auto& channel = channels_[{absoluteTopic(topic), *typeName}];
  if (!channel) channel = std::make_unique<Channel>(absoluteTopic(topic), *typeName);
  return *channel;
}

void Bus::eraseIfUnused(const Channel& channel) {
  if (channel.publishers + channel.subscriptions == 0) channels_.erase({channel.topic, channel.type});
}

Channel& Bus::addPublisher(std::string_view topic, std::string_view type) {
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  if (network_ && !channel.writer) {
    channel.writer = network_->makeWriter(channel.topic, channel.type, [this] { subscribersChanged(); });
    network_->directory().addOwn({channel.topic, channel.type, Role::kPublisher});
  }
  ++channel.publishers;
  return channel;
}

void Bus::endPublisher(Channel& channel) {
  const std::lock_guard lock(setUp_);
  if (--channel.publishers > 0) return;
  if (channel.writer) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kPublisher});
    network_->end(std::move(channel.writer));
  }
  eraseIfUnused(channel);
}

Inbox& Bus::addSubscription(std::string_view topic, std::string_view type, Inbox::Received received,
                            std::size_t limit) {
  const std::lock_guard lock(setUp_);
  Channel& channel = channelFor(topic, type);
  auto owned = std::make_unique<Inbox>(channel, newMessage(channel.type), std::move(received), limit);
  Inbox& inbox = *owned;
  ++channel.subscriptions;
  {
    const std::lock_guard inboxesLock(mutex_);
    inboxes_.emplace(&inbox, std::move(owned));
    channel.inboxes.push_back(&inbox);
    ++channel.inboxCount;
  }
  try {
    openReader(channel);
  } catch (...) {
    const std::lock_guard inboxesLock(mutex_);
    std::erase(channel.inboxes, &inbox);
    --channel.inboxCount;
    --channel.subscriptions;
    inboxes_.erase(&inbox);
    throw;
  }
  subscribersChanged_.notify_all();
  return inbox;
}

// Not before there is an inbox: what came at once would be acknowledged, and lost.
void Bus::openReader(Channel& channel) {
  if (!network_ || channel.reader) return;
  channel.reader = network_->makeReader(
      channel.topic, channel.type,
      [this, &channel](const ParticipantId& sender, auto payload) { receive(channel, sender, payload); });
  network_->directory().addOwn({channel.topic, channel.type, Role::kSubscriber});
}

void Bus::endSubscription(Inbox& inbox) {
  const std::lock_guard dispatchLock(dispatching_);
  const std::lock_guard lock(setUp_);
  Channel& channel = inbox.channel();
  {
    const std::lock_guard inboxesLock(mutex_);
    std::erase(channel.inboxes, &inbox);
    --channel.inboxCount;
    std::erase(inboxesWithArrivals_, &inbox);
    std::vector<Arrival> unread;
    inbox.moveTo(unread);
    for (const Arrival& arrival : unread) buffers_.giveBack(arrival.buffer);
    inbox.ended = true;
    if (inDispatch_) {
      endedInDispatch_.push_back(&inbox);
    } else {
      inboxes_.erase(&inbox);
    }
  }
  if (--channel.subscriptions > 0) return;
  if (channel.reader) {
    network_->directory().removeOwn({channel.topic, channel.type, Role::kSubscriber});
    network_->end(std::move(channel.reader));
  }
  eraseIfUnused(channel);
}

bool Bus::hasSubscribers(const Channel& channel) const {
  return channel.inboxCount.load(std::memory_order_relaxed) > 0 || (channel.writer && channel.writer->hasReaders());
}

void Bus::publish(Channel& channel, const Message& message) {
  if (msgs::typeName(message) != channel.type) {
    throw std::invalid_argument("topic '" + channel.topic + "' is of " + channel.type + ", not of " +
                                msgs::typeName(message));
  }
  const bool here = channel.inboxCount.load(std::memory_order_relaxed) > 0;
  const bool elsewhere = channel.writer && channel.writer->hasReaders();
  if (!here && !elsewhere) return;

  const std::size_t size = msgs::byteSize(message);
  if (size > kMaximumMessage) {
    busLog().error("topic '" + channel.topic + "': a message of " + std::to_string(size) +
                   " bytes is too large to send");
    return;
  }
  const auto serialize = [&message](std::span<std::byte> place) { msgs::writeBytes(message, place); };
  if (!here) {
    channel.writer->write(size, serialize);
    return;
  }
  Buffer* buffer = takeBuffer();
  buffer->bytes.resize(size);
  buffer->sender = {};
  serialize(buffer->bytes);
  if (elsewhere) {
    channel.writer->write(size,
                          [buffer](std::span<std::byte> place) { std::ranges::copy(buffer->bytes, place.begin()); });
  }
  deliver(channel, buffer);
}

void Bus::receive(Channel& channel, const ParticipantId& sender, std::span<const std::byte> payload) {
  const std::optional<std::span<const std::byte>> message = messageInPayload(payload);
  if (!message) {
    complain(channel, sender, "is damaged");
    return;
  }
  Buffer* buffer = takeBuffer();
  buffer->bytes.assign(message->begin(), message->end());
  buffer->sender = sender;
  deliver(channel, buffer);
}

Buffer* Bus::takeBuffer() {
  const std::lock_guard lock(mutex_);
  return buffers_.take();
}

void Bus::deliver(Channel& channel, Buffer* buffer) {
  {
    const std::lock_guard lock(mutex_);
    for (Inbox* inbox : channel.inboxes) {
      if (inbox->size() == 0) inboxesWithArrivals_.push_back(inbox);
      ++buffer->users;
      if (Buffer* oldest = inbox->add(nextArrival_++, buffer)) buffers_.giveBack(oldest);
    }
    buffers_.giveBack(buffer);
    waiting_ = !inboxesWithArrivals_.empty();
  }
  arrived_.notify_one();
}

std::size_t Bus::collectArrivals() {
  const std::lock_guard lock(mutex_);
  for (Inbox* inbox : inboxesWithArrivals_) inbox->moveTo(arrivals_);
  inboxesWithArrivals_.clear();
  waiting_ = false;
  std::ranges::sort(arrivals_, {}, &Arrival::number);
  return arrivals_.size();
}

void Bus::releaseArrivals() {
  const std::lock_guard lock(mutex_);
  for (const Arrival& arrival : arrivals_) buffers_.giveBack(arrival.buffer);
  arrivals_.clear();
  for (Inbox* inbox : endedInDispatch_) inboxes_.erase(inbox);
  endedInDispatch_.clear();
  inDispatch_ = false;
}

std::size_t Bus::dispatch() {
  if (!waiting_.load(std::memory_order_relaxed) && !server_.waiting()) return 0;
  const std::lock_guard lock(dispatching_);
  if (inDispatch_) throw std::logic_error("dispatch was called from a function that dispatch had called");
  inDispatch_ = true;
  dispatcher_ = std::this_thread::get_id();

  // also when a called function throws
  struct Release {
    ~Release() {
      bus.dispatcher_ = std::thread::id();
      bus.releaseArrivals();
    }
    Bus& bus;
  } const release{*this};

  std::size_t handedOver = 0;
  collectArrivals();
  for (const Arrival& arrival : arrivals_) {
    Inbox& inbox = *arrival.inbox;
    if (inbox.ended) continue;
    if (inbox.parse(*arrival.buffer)) {
      ++handedOver;
      inbox.handOver();
    } else {
      complain(inbox.channel(), arrival.buffer->sender, "is no " + inbox.channel().type);
    }
  }
  return handedOver + server_.dispatch();
}

std::size_t Bus::dispatchFor(std::chrono::nanoseconds timeout) {
  {
    std::unique_lock lock(mutex_);
    arrived_.wait_until(lock, deadlineAfter(timeout), [this] { return woken_ || waiting_ || server_.waiting(); });
    woken_ = false;
  }
  return dispatch();
}

void Bus::wake() {
  {
    const std::lock_guard lock(mutex_);
    woken_ = true;
  }
  arrived_.notify_one();
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
                   (sender == ParticipantId{} ? "this process" : "process " + std::to_string(pid)) + " " +
                   std::string(what) + "; dropped" +
                   (*unmentioned > 0 ? " (and " + std::to_string(*unmentioned) + " before it)" : ""));
}

void Bus::subscribersChanged() {
  // whoever is about to wait has looked either before, and waits by now, or afterwards
  { const std::lock_guard lock(mutex_); }
  subscribersChanged_.notify_all();
}

void Bus::requestArrived() {
  { const std::lock_guard lock(mutex_); }
  arrived_.notify_one();
}

bool Bus::waitForSubscribers(const Channel& channel, std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  return subscribersChanged_.wait_until(lock, deadlineAfter(timeout), [&] { return hasSubscribers(channel); });
}

bool Bus::waitForDelivery(const Channel& channel, std::chrono::nanoseconds timeout) {
  return !channel.writer || channel.writer->waitForAcknowledgement(timeout);
}

std::uint64_t Bus::dropped(const Inbox& inbox) const {
  const std::lock_guard lock(mutex_);
  return inbox.dropped();
}

std::vector<TopicInfo> Bus::discover(std::chrono::nanoseconds timeout) {
  if (!network_) return {};
  network_->discover(timeout);
  return network_->directory().topics();
}

TopicInfo Bus::waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout) {
  const std::string name = absoluteTopic(topic);
  if (!network_) return {name, {}, {}};
  network_->directory().waitForTopic(name, wantPublisher ? Role::kPublisher : Role::kSubscriber,
                                     deadlineAfter(timeout));
  return network_->directory().topic(name);
}

Offer& Bus::addService(std::string_view service, std::string_view requestType, std::string_view replyType,
                       ServiceHandler handler) {
  const std::lock_guard lock(setUp_);
  return server_.add(service, requestType, replyType, std::move(handler));
}

void Bus::endService(Offer& offer) {
  const std::lock_guard dispatchLock(dispatching_);
  const std::lock_guard lock(setUp_);
  server_.end(offer, inDispatch_);
}

CallResult Bus::call(std::string_view service, const Message& request, Message& reply,
                     std::chrono::nanoseconds timeout) {
  if (dispatcher_ == std::this_thread::get_id()) {
    throw std::logic_error("a service was called from a function that dispatch had called, which must not wait");
  }
  return client_.call(service, request, reply, deadlineAfter(timeout));
}

std::vector<ServiceInfo> Bus::discoverServices(std::chrono::nanoseconds timeout) {
  if (!network_) return {};
  network_->discover(timeout);
  return network_->directory().services();
}

ServiceInfo Bus::waitForService(std::string_view service, std::chrono::nanoseconds timeout) {
  const std::string name = absoluteService(service);
  if (!network_) return {name, {}};
  network_->directory().waitForTopic(requestTopic(name), Role::kSubscriber, deadlineAfter(timeout));
  return network_->directory().service(name);
}

}  // namespace pongsim::transport
