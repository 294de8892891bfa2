#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pongsim/node.hh"

namespace pongsim::transport {

class Bus;
class Channel;
class DispatchQueue;
class Writer;

/// What a `Publisher` has.
struct PublisherState {
  Bus& bus;
  DispatchQueue& queue;
  Channel& channel;
  /// To other processes; null if it publishes to none.
  Writer* const writer;
  const PublisherOptions options;
  /// Of the system that publishes, or null.
  const CallGuard* const guard;
  std::atomic<std::uint64_t> sent = 0;
  /// Subscribers reported so far.
  std::uint64_t knownSubscribers = 0;

  bool hasSubscribers() const;
};

/// Publishes bytes that an interceptor has passed.
void publishPassed(PublisherState& publisher, std::span<const std::byte> bytes);

}  // namespace pongsim::transport
