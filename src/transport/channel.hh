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
#include "transport/buffer_pool.hh"
#include "transport/complaint_limit.hh"

namespace pongsim::transport {

class DispatchQueue;
class Inbox;
class Reader;
class Writer;

class Channel;

/// A call of subscriptions at once: one thread at a time, which may publish on the same topic in turn.
class Hearing {
 public:
  explicit Hearing(Channel& channel);
  ~Hearing();
  Hearing(const Hearing&) = delete;
  Hearing& operator=(const Hearing&) = delete;

 private:
  Channel& channel_;
  const std::lock_guard<std::recursive_mutex> lock_;
  const std::thread::id outer_;
};

/// A topic with one type of message: all its publishers and subscriptions in this process.
class Channel {
 public:
  Channel(std::string topic, std::string type);
  ~Channel();

  const std::string topic;
  const std::string type;

  /// Counts a publisher in (`change` 1) or out (-1). Needs the bus's set-up mutex.
  void countPublisher(DispatchQueue& queue, const PublisherOptions& publisher, int change);
  /// Counts a subscription in (1) or out (-1). Needs both mutexes of the bus.
  void countSubscription(const Inbox& inbox, int change);
  /// Updates `atOnceQueue` and `isAtOnceInSeveral` after a change of `atOnce`. Needs `hearing`.
  void countAtOnceQueues();

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
  /// In total, and by transport (its queue). Guarded by the bus's set-up mutex, as are the next two.
  Users users;
  std::map<const DispatchQueue*, Users> usersOf;
  /// Sends to other processes; null without a publisher that does.
  std::unique_ptr<Writer> writer;
  /// Receives from other processes; null without a subscription that does.
  std::unique_ptr<Reader> reader;

  /// All subscriptions, in the order of subscribing. Guarded by the bus's mutex.
  std::vector<Inbox*> inboxes;
  /// Of ordinary subscriptions: those at once are in `atOnceCount`.
  std::atomic<int> inboxCount = 0;
  std::atomic<std::uint64_t> inboxesSoFar = 0;
  std::atomic<std::uint64_t> sent = 0;

  /// Guards `atOnce`. Held while the subscriptions' functions are called, which may publish in turn.
  std::recursive_mutex hearing;
  /// The thread that calls such a function, if any. Written with `hearing` held.
  std::atomic<std::thread::id> hearer;
  /// Subscriptions that receive messages within `publish`.
  std::vector<Inbox*> atOnce;
  std::atomic<int> atOnceCount = 0;
  /// The first transport with such subscriptions, null without any, and whether there are others.
  std::atomic<const DispatchQueue*> atOnceQueue = nullptr;
  std::atomic<bool> isAtOnceInSeveral = false;
  /// Subscriptions of either kind that relay.
  std::atomic<int> relayingCount = 0;
  /// A message that published bytes are parsed into for them, or null.
  MessagePointer read;

  /// The last message, for later subscribers, or null. Guarded by the bus's mutex.
  Buffer* latched = nullptr;

  /// Limits warnings about bad messages. Guarded by the bus's mutex.
  ComplaintLimit complaints;
};

}  // namespace pongsim::transport
