// What a publisher sends: who hears it, and how it gets there.
#include <algorithm>
#include <stdexcept>

#include "msgs/encoding/bytes.hh"
#include "pongsim/log.hh"
#include "transport/bus.hh"
#include "transport/deadline.hh"
#include "transport/network/network.hh"
#include "transport/payload.hh"

namespace pongsim::transport {

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

/// @return Whether others want it than those who hear at once. What these alone hear is counted as sent here.
bool Bus::isWantedInBytes(PublisherState& publisher) {
  Channel& channel = publisher.channel;
  if (channel.needsInboxes(publisher.queue, publisher.options)) return true;
  if (!publisher.options.ownOnly && channel.writer && channel.writer->hasReaders()) return true;
  ++publisher.sent;
  ++channel.sent;
  return false;
}

void Bus::hearAtOnce(PublisherState& publisher, const Message& message, const Bulk* bulk) {
  Channel& channel = publisher.channel;
  if (channel.atOnceCount.load(std::memory_order_relaxed) == 0) return;
  const Hearing hearing(channel);
  // by number: what is called may publish on this topic in turn
  for (std::size_t i = 0; i < channel.atOnce.size(); ++i) {
    const Inbox& inbox = *channel.atOnce[i];
    if (inbox.ended || inbox.queue != &publisher.queue || !inbox.hears(publisher)) continue;
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
  const Hearing hearing(channel);
  const auto copy = [bytes](std::span<std::byte> place) { std::copy(bytes.begin(), bytes.end(), place.begin()); };
  bool isRead = false;
  for (std::size_t i = 0; i < channel.atOnce.size(); ++i) {
    const Inbox& inbox = *channel.atOnce[i];
    if (inbox.ended || inbox.queue != &publisher.queue || !inbox.hears(publisher)) continue;
    if (inbox.heardBytesAtOnce) {
      inbox.heardBytesAtOnce(bytes.size(), copy);
      continue;
    }
    if (!channel.read) channel.read = newMessage(channel.type);
    if (!isRead && !(channel.read && msgs::parseBytes(bytes, *channel.read))) {
      complain(channel, kThisProcess, "is not of type " + channel.type);
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
    static const Logger log("transport");
    log.error("topic '" + channel.topic + "': a message of " + std::to_string(size) + " bytes is too large to send");
    return;
  }
  ++publisher.sent;
  ++channel.sent;
  const bool latched = publisher.options.latched;
  const bool here = channel.needsInboxes(publisher.queue, publisher.options);
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

bool Bus::waitForSubscribers(const PublisherState& publisher, std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  return subscribersChanged_.wait_until(lock, deadlineAfter(timeout), [&] { return hasSubscribers(publisher); });
}

bool Bus::waitForDelivery(const Channel& channel, std::chrono::nanoseconds timeout) {
  return !channel.writer || channel.writer->waitForAcknowledgement(timeout);
}

}  // namespace pongsim::transport
