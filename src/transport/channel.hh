#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "shared/threads/complaint_limit.hh"
#include "transport/locks.hh"
#include "transport/parcel.hh"

namespace pongsim::transport {

class DispatchQueue;
class Inbox;
class Interceptor;
class Reader;
class Writer;

/// A topic with one type of message: all its publishers and subscriptions in this process.
class Channel {
 public:
  /// @param unused The unused parcels of the type, for its messages.
  Channel(std::string topic, std::string type, SpareParcels& unused);
  ~Channel();

  const std::string topic;
  const std::string type;
  SpareParcels& spare;

  /// Counts a publisher in (`change` 1) or out (-1).
  void countPublisher(DispatchQueue& queue, const PublisherOptions& publisher, int change) REQUIRES(setUpRole);
  /// Counts a subscription in (1) or out (-1).
  void countSubscription(const Inbox& inbox, int change) REQUIRES(setUpRole, waitingRole);
  /// Updates `atOnceQueue` and `isAtOnceInSeveral` after a change of `atOnce`.
  void countAtOnceQueues() REQUIRES(hearingRole);

  /// @return Whether a publisher's messages go into inboxes: those of all ordinary subscriptions, and of subscriptions
  /// at once in other transports than the publisher's.
  bool needsInboxes(const DispatchQueue& queue, const PublisherOptions& publisher) const;

  /// Numbers of endpoints.
  struct Users {
    int publishers = 0;
    int latchedPublishers = 0;
    int relayingPublishers = 0;
    int ownOnlyPublishers = 0;
    int subscriptions = 0;
    int relayingSubscriptions = 0;
    int ownOnlySubscriptions = 0;
  };
  /// In total, and by transport (its queue).
  Users users GUARDED_BY(setUpRole);
  std::map<const DispatchQueue*, Users> usersOf GUARDED_BY(setUpRole);
  /// Sends to other processes; null without a publisher that does.
  std::unique_ptr<Writer> writer GUARDED_BY(setUpRole);
  /// Receives from other processes; null without a subscription that does.
  std::unique_ptr<Reader> reader GUARDED_BY(setUpRole);

  /// Takes the messages on their way; null: nobody does. Changed with the set-up mutex held.
  std::atomic<Interceptor*> interceptor = nullptr;

  /// All subscriptions, in the order of subscribing.
  std::vector<Inbox*> inboxes GUARDED_BY(waitingRole);
  /// Of ordinary subscriptions: those at once are in `atOnceCount`.
  std::atomic<int> inboxCount = 0;
  std::atomic<std::uint64_t> inboxesSoFar = 0;
  std::atomic<std::uint64_t> sent = 0;

  /// Guards `atOnce`. Held while the subscriptions' functions are called, which may publish in turn.
  std::recursive_mutex hearing;
  /// The thread that holds it, if any.
  std::atomic<std::thread::id> hearer;
  /// Subscriptions that receive messages within `publish`.
  std::vector<Inbox*> atOnce GUARDED_BY(hearingRole);
  std::atomic<int> atOnceCount = 0;
  /// The first transport with such subscriptions, null without any, and whether there are others.
  std::atomic<const DispatchQueue*> atOnceQueue = nullptr;
  std::atomic<bool> isAtOnceInSeveral = false;
  /// Subscriptions of either kind that relay.
  std::atomic<int> relayingCount = 0;
  /// A message that published bytes are parsed into for them, or null.
  MessagePointer read GUARDED_BY(hearingRole);

  /// The last message, for later subscribers, or null.
  Parcel* latched GUARDED_BY(waitingRole) = nullptr;

  /// Limits warnings about bad messages.
  shared::ComplaintLimit complaints GUARDED_BY(waitingRole);
};

/// Holds `hearing`: one thread at a time calls subscriptions at once, or changes their list.
class SCOPED_CAPABILITY Hearing {
 public:
  explicit Hearing(Channel& channel) ACQUIRE(hearingRole)
      : channel_(channel), lock_(channel.hearing), outer_(channel.hearer.exchange(std::this_thread::get_id())) {}
  ~Hearing() RELEASE() { channel_.hearer = outer_; }
  Hearing(const Hearing&) = delete;
  Hearing& operator=(const Hearing&) = delete;

 private:
  Channel& channel_;
  const std::lock_guard<std::recursive_mutex> lock_;
  /// This thread, where it held the mutex already.
  const std::thread::id outer_;
};

}  // namespace pongsim::transport
