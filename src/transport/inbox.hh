#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "transport/locks.hh"
#include "transport/parcel.hh"

namespace pongsim::transport {

class Channel;
class DispatchQueue;
class Reader;
struct PublisherState;

/// A message for one subscription.
struct Arrival {
  /// Counted since the transport's start, over all subscriptions.
  std::uint64_t number = 0;
  class Inbox* inbox = nullptr;
  Parcel* parcel = nullptr;
  /// Whether it is from another transport, another process or a carrier, which a `Gate` holds.
  bool isOutside = false;
};

/// A subscription: its function, and the messages that wait for it.
class Inbox {
 public:
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  /// What a subscription calls: a function for messages or for bytes, later or at once, or for bytes of any type.
  using Function = std::variant<std::function<void(const Message&)>, std::function<void(std::span<const std::byte>)>,
                                HeardAtOnce, HeardBytesAtOnce, std::shared_ptr<const ReceivedOfAnyType>>;

  /// @param guard Makes the calls of the function; may be null.
  Inbox(Channel& channel, DispatchQueue& queue, Function function, const SubscriptionOptions& options,
        CallGuard* guard = nullptr);
  ~Inbox();

  /// @return The publisher that a subscription with these options ignores, or null.
  static const void* excepted(const SubscriptionOptions& options);

  /// Appends a message. If there is no room, the oldest ones are moved to `dropped` and counted.
  void add(std::uint64_t number, Parcel* parcel, bool isOutside, std::vector<Parcel*>& dropped) REQUIRES(waitingRole);
  /// Moves the waiting messages to the end of `arrivals`: of those from outside the ones with numbers below `limit`.
  void moveTo(std::vector<Arrival>& arrivals, std::uint64_t limit = kNoLimit) REQUIRES(waitingRole);
  /// Forgets all waiting messages but `kept`. Takes no memory.
  void forgetUnread(ParcelPool& pool, const Parcel* kept = nullptr) REQUIRES(waitingRole);
  std::size_t size() const REQUIRES(waitingRole) { return waiting_.size() - first_; }
  std::span<const Arrival> waiting() const REQUIRES(waitingRole) { return std::span(waiting_).subspan(first_); }
  /// Without dropped ones.
  std::uint64_t received() const REQUIRES(waitingRole) { return added_ - dropped_; }
  std::uint64_t dropped() const REQUIRES(waitingRole) { return dropped_; }

  /// Passes a message to the subscription, within `dispatch`.
  /// @return Why it can't be used ("is not of type ignition.msgs.Twist"), or nothing.
  std::optional<std::string> handOver(Parcel& parcel);

  /// @return Why the subscription refuses the message's numbers, or nothing.
  std::optional<std::string> refusal(const Message& message) const;

  /// Passes a message to a subscription at once, within `publish`.
  void hear(const Message& message, const Bulk* bulk) const;
  void hearBytes(std::size_t size, const std::function<void(std::span<std::byte>)>& write) const;
  /// @return Whether its function belongs to the queue's world.
  bool isOfWorld() const { return guard_ != nullptr && guard_->isOfWorld(); }
  /// @return Whether it receives messages of its own transport within `publish`.
  bool isAtOnce() const { return hearsMessages() || hearsBytes(); }
  bool hearsMessages() const { return std::holds_alternative<HeardAtOnce>(function_); }
  bool hearsBytes() const { return std::holds_alternative<HeardBytesAtOnce>(function_); }

  /// @return Whether it receives from that publisher of its own transport.
  bool accepts(const PublisherState& publisher) const;

  Channel& channel;
  /// Where it waits for `dispatch`.
  DispatchQueue& queue;
  /// As in the subscription's options.
  const bool relays;
  const bool ownOnly;
  /// The publisher that it ignores, or null.
  const void* except;
  /// Whether its subscription has ended.
  std::atomic<bool> ended = false;
  /// The channel's reader, and what that had lost before this subscription. Null if it receives from no other process.
  const Reader* reader = nullptr;
  std::uint64_t lostBefore = 0;

 private:
  std::optional<std::string> handOverMessage(Parcel& parcel);
  template <class Call>
  void call(CallGuard::Moment moment, const Call& function) const;
  void clear() REQUIRES(waitingRole);
  Parcel* removeOldest() REQUIRES(waitingRole);

  Function function_;
  CallGuard* const guard_;
  const std::size_t queueLength_;
  const std::optional<double> largestNumber_;
  std::vector<Arrival> waiting_ GUARDED_BY(waitingRole);
  /// Those before it were dropped.
  std::size_t first_ GUARDED_BY(waitingRole) = 0;
  std::size_t waitingBytes_ GUARDED_BY(waitingRole) = 0;
  std::uint64_t added_ GUARDED_BY(waitingRole) = 0;
  std::uint64_t dropped_ GUARDED_BY(waitingRole) = 0;
};

}  // namespace pongsim::transport
