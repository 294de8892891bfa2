// What a publisher sends, and to whom.
#include "transport/publisher.hh"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "msgs/encoding/bytes.hh"
#include "pongsim/log.hh"
#include "transport/bus.hh"
#include "transport/interceptor.hh"
#include "transport/network/endpoint.hh"
#include "transport/payload.hh"

namespace pongsim {

namespace transport {

bool PublisherState::hasSubscribers() const {
  const int here = channel.inboxCount.load(std::memory_order_relaxed) +
                   channel.atOnceCount.load(std::memory_order_relaxed) -
                   (options.relays ? channel.relayingCount.load(std::memory_order_relaxed) : 0);
  return here > 0 || (writer != nullptr && writer->hasReaders());
}

namespace {

using Fill = std::function<void(std::span<std::byte>)>;

bool isAwaited(const PublisherState& publisher) { return publisher.options.latched || publisher.hasSubscribers(); }

/// Calls `call` with each subscription at once that receives from the publisher.
template <class Call>
void forEachAtOnce(const PublisherState& publisher, const Call& call) {
  Channel& channel = publisher.channel;
  if (channel.atOnceCount.load(std::memory_order_relaxed) == 0) return;
  const Hearing hearing(channel);
  for (const Inbox* inbox : channel.atOnce) {
    if (!inbox->ended && &inbox->queue == &publisher.queue && inbox->accepts(publisher)) call(*inbox);
  }
}

/// Whether a message goes to subscriptions of this process later, in `dispatch`, and whether to other processes.
struct Destinations {
  bool here;
  bool elsewhere;
};

Destinations destinationsOf(const PublisherState& publisher) {
  return {publisher.channel.needsInboxes(publisher.queue, publisher.options),
          publisher.writer != nullptr && (publisher.options.latched || publisher.writer->hasReaders())};
}

/// Sends a message, which `fill` writes, to those who do not receive it at once.
void sendLater(PublisherState& publisher, const Destinations& to, std::size_t size, const Fill& fill) {
  Channel& channel = publisher.channel;
  if (size > kMaximumMessage) {
    static const Logger log("transport");
    log.error("topic '" + channel.topic + "': a message of " + std::to_string(size) + " bytes is too large to send");
    return;
  }
  ++publisher.sent;
  ++channel.sent;
  const bool latched = publisher.options.latched;
  const Keeping keeping = latched ? Keeping::kKept : Keeping::kNone;
  if (!to.here) {
    if (to.elsewhere) publisher.writer->write(size, fill, keeping);
    return;
  }
  Delivery& delivery = publisher.bus.delivery();
  Parcel* parcel = delivery.take(channel, size);
  if (publisher.guard != nullptr && publisher.guard->isActing()) parcel->origin = &publisher.queue;
  const std::span<std::byte> bytes = parcel->bytes->bytes;
  fill(bytes);
  // with std::ranges, GCC 12 copies single bytes
  const auto copy = [bytes](std::span<std::byte> place) { std::copy(bytes.begin(), bytes.end(), place.begin()); };
  if (to.elsewhere) publisher.writer->write(size, copy, keeping);
  delivery.deliver(channel, parcel, latched, &publisher);
}

/// @return Who takes the publisher's messages on their way; null: nobody.
Interceptor* interceptorOf(const PublisherState& publisher) {
  Interceptor* const interceptor = publisher.channel.interceptor.load(std::memory_order_relaxed);
  // what carriers bring is taken where it is handed over
  const bool isTaken = interceptor != nullptr && !publisher.options.relays && &interceptor->queue == &publisher.queue;
  return isTaken ? interceptor : nullptr;
}

void passThrough(Interceptor& interceptor, PublisherState& publisher, std::span<const std::byte> bytes) {
  interceptor.takeOutgoing(publisher.channel.type, bytes,
                           [&publisher](std::span<const std::byte> passed) { publishPassed(publisher, passed); });
}

/// The same for a message, which `fill` writes.
void passThrough(Interceptor& interceptor, PublisherState& publisher, std::size_t size, const Fill& fill) {
  std::vector<std::byte> bytes(size);
  fill(bytes);
  passThrough(interceptor, publisher, bytes);
}

}  // namespace

void publishPassed(PublisherState& publisher, std::span<const std::byte> bytes) {
  if (!isAwaited(publisher)) return;
  Channel& channel = publisher.channel;
  const Fill fill = [bytes](std::span<std::byte> place) { std::copy(bytes.begin(), bytes.end(), place.begin()); };
  const Message* parsed = nullptr;
  bool isMessage = true;
  forEachAtOnce(publisher, [&](const Inbox& inbox) REQUIRES(hearingRole) {
    if (inbox.hearsBytes()) return inbox.hearBytes(bytes.size(), fill);
    if (parsed == nullptr && isMessage) {
      if (!channel.read) channel.read = newMessage(channel.type);
      isMessage = channel.read && msgs::parseBytes(bytes, *channel.read);
      if (!isMessage) publisher.bus.complain(channel, kThisProcess, "is not of type " + channel.type);
      parsed = channel.read.get();
    }
    if (isMessage) inbox.hear(*parsed, nullptr);
  });
  sendLater(publisher, destinationsOf(publisher), bytes.size(), fill);
}

}  // namespace transport

void Publisher::End::operator()(transport::PublisherState* state) const {
  state->bus.end(*state);
  delete state;
}

bool Publisher::hasSubscribers() const { return state_ && state_->hasSubscribers(); }

std::uint64_t Publisher::newSubscribers() {
  if (!state_) return 0;
  const std::uint64_t elsewhere = state_->writer == nullptr ? 0 : state_->writer->readersSoFar();
  const std::uint64_t soFar = state_->channel.inboxesSoFar + elsewhere;
  return soFar - std::exchange(state_->knownSubscribers, soFar);
}

void Publisher::publish(const Message& message) {
  if (!state_) return;
  const transport::Channel& channel = state_->channel;
  if (msgs::typeName(message) != channel.type) {
    throw std::invalid_argument("topic '" + channel.topic + "' is of " + channel.type + ", not of " +
                                msgs::typeName(message));
  }
  if (!transport::isAwaited(*state_)) return;
  const transport::Fill fill = [&message](std::span<std::byte> place) { msgs::writeBytes(message, place); };
  if (auto* interceptor = transport::interceptorOf(*state_)) {
    return transport::passThrough(*interceptor, *state_, msgs::byteSize(message), fill);
  }
  transport::forEachAtOnce(*state_, [&](const transport::Inbox& inbox) {
    if (inbox.hearsMessages()) return inbox.hear(message, nullptr);
    inbox.hearBytes(msgs::byteSize(message), fill);
  });
  const transport::Destinations to = transport::destinationsOf(*state_);
  const std::size_t size = to.here || to.elsewhere ? msgs::byteSize(message) : 0;
  transport::sendLater(*state_, to, size, fill);
}

void Publisher::publish(const Message& message, const Bulk& bulk) {
  if (!state_) return;
  const transport::Channel& channel = state_->channel;
  const std::optional<msgs::BulkWriter> writer = msgs::BulkWriter::of(message, bulk);
  if (msgs::typeName(message) != channel.type || !writer) {
    throw std::invalid_argument("topic '" + channel.topic + "' is of " + channel.type + ", not of " +
                                msgs::typeName(message) + " with bytes in '" + bulk.field + "'");
  }
  if (!transport::isAwaited(*state_)) return;
  const transport::Fill fill = [&writer](std::span<std::byte> place) { writer->write(place); };
  if (auto* interceptor = transport::interceptorOf(*state_)) {
    return transport::passThrough(*interceptor, *state_, writer->size(), fill);
  }
  transport::forEachAtOnce(*state_, [&](const transport::Inbox& inbox) {
    if (inbox.hearsMessages()) return inbox.hear(message, &bulk);
    inbox.hearBytes(writer->size(), fill);
  });
  transport::sendLater(*state_, transport::destinationsOf(*state_), writer->size(), fill);
}

void Publisher::publishBytes(std::span<const std::byte> bytes) {
  if (!state_ || !transport::isAwaited(*state_)) return;
  if (auto* interceptor = transport::interceptorOf(*state_)) {
    return transport::passThrough(*interceptor, *state_, bytes);
  }
  transport::publishPassed(*state_, bytes);
}

std::uint64_t Publisher::sent() const { return state_ ? state_->sent.load() : 0; }

bool Publisher::waitForSubscribers(std::chrono::nanoseconds timeout) const {
  return state_ && state_->bus.delivery().waitForSubscribers(*state_, timeout);
}

bool Publisher::waitForDelivery(std::chrono::nanoseconds timeout) const {
  return state_ && (state_->writer == nullptr || state_->writer->waitForAcknowledgement(timeout));
}

}  // namespace pongsim
