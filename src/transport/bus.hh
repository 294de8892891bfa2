#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "transport/complaint_limit.hh"
#include "transport/inbox.hh"
#include "transport/service_client.hh"
#include "transport/service_server.hh"

namespace pongsim::transport {

class Network;
class Reader;
class Writer;

/// A topic as one type of message: all publishers and subscriptions of this transport.
class Channel {
 public:
  Channel(std::string topic, std::string type);
  ~Channel();

  const std::string topic;
  const std::string type;

  /// Guarded by the bus's set-up mutex. The writer is there while a publisher is, the reader while a subscription is.
  int publishers = 0;
  int subscriptions = 0;
  std::unique_ptr<Writer> writer;
  std::unique_ptr<Reader> reader;

  /// Guarded by the bus's mutex, in the order of subscribing.
  std::vector<Inbox*> inboxes;
  std::atomic<int> inboxCount = 0;

  /// Of bad messages; guarded by the bus's mutex.
  ComplaintLimit complaints;
};

/// Takes messages from publishers and from the network to the subscriptions of one `Transport`.
///
/// Three mutexes, taken in this order: `dispatching_` (one dispatch at a time, and no subscription ends during another
/// thread's), `setUp_` (making and ending endpoints), `mutex_` (what waits). DDS threads take only the last, which is
/// therefore never held while DDS is called.
class Bus {
 public:
  /// @param network Null for a transport of this process only.
  explicit Bus(std::unique_ptr<Network> network);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  Channel& addPublisher(std::string_view topic, std::string_view type);
  void endPublisher(Channel& channel);
  Inbox& addSubscription(std::string_view topic, std::string_view type, Inbox::Received received, std::size_t limit);
  void endSubscription(Inbox& inbox);

  bool hasSubscribers(const Channel& channel) const;
  void publish(Channel& channel, const Message& message);
  bool waitForSubscribers(const Channel& channel, std::chrono::nanoseconds timeout);
  bool waitForDelivery(const Channel& channel, std::chrono::nanoseconds timeout);
  std::uint64_t dropped(const Inbox& inbox) const;

  std::size_t dispatch();
  std::size_t dispatchFor(std::chrono::nanoseconds timeout);
  void wake();

  std::vector<TopicInfo> discover(std::chrono::nanoseconds timeout);
  TopicInfo waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout);

  Offer& addService(std::string_view service, std::string_view requestType, std::string_view replyType,
                    ServiceHandler handler);
  void endService(Offer& offer);
  CallResult call(std::string_view service, const Message& request, Message& reply, std::chrono::nanoseconds timeout);
  std::vector<ServiceInfo> discoverServices(std::chrono::nanoseconds timeout);
  ServiceInfo waitForService(std::string_view service, std::chrono::nanoseconds timeout);

 private:
  Channel& channelFor(std::string_view topic, std::string_view type);
  void openReader(Channel& channel);
  void deliver(Channel& channel, Buffer* buffer);
  void receive(Channel& channel, const ParticipantId& sender, std::span<const std::byte> payload);
  Buffer* takeBuffer();
  std::size_t collectArrivals();
  void releaseArrivals();
  void eraseIfUnused(const Channel& channel);
  void complain(Channel& channel, const ParticipantId& sender, std::string_view what);
  void subscribersChanged();
  void requestArrived();

  std::unique_ptr<Network> network_;

  std::recursive_mutex dispatching_;
  std::vector<Arrival> arrivals_;
  bool inDispatch_ = false;
  /// Who dispatches now.
  std::atomic<std::thread::id> dispatcher_;
  /// Ended by a function that `dispatch` called, for which they must stay until it returns.
  std::vector<Inbox*> endedInDispatch_;

  std::mutex setUp_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<Channel>> channels_;

  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::condition_variable subscribersChanged_;
  std::map<Inbox*, std::unique_ptr<Inbox>> inboxes_;
  std::vector<Inbox*> inboxesWithArrivals_;
  BufferPool buffers_;
  std::uint64_t nextArrival_ = 0;
  std::atomic<bool> waiting_ = false;
  bool woken_ = false;

  ServiceServer server_;
  ServiceClient client_;
};

/// A publisher's share in its topic.
class PublisherState {
 public:
  PublisherState(Bus& owner, Channel& topic) : bus(owner), channel(topic) {}
  ~PublisherState() { bus.endPublisher(channel); }
  PublisherState(const PublisherState&) = delete;
  PublisherState& operator=(const PublisherState&) = delete;

  Bus& bus;
  Channel& channel;
};

/// A service's share in its transport.
class ServiceState {
 public:
  ServiceState(Bus& owner, Offer& service) : bus(owner), offer(service) {}
  ~ServiceState() { bus.endService(offer); }
  ServiceState(const ServiceState&) = delete;
  ServiceState& operator=(const ServiceState&) = delete;

  Bus& bus;
  Offer& offer;
};

/// A subscription's place to wait for messages.
class SubscriptionState {
 public:
  SubscriptionState(Bus& owner, Inbox& place) : bus(owner), inbox(place) {}
  ~SubscriptionState() { bus.endSubscription(inbox); }
  SubscriptionState(const SubscriptionState&) = delete;
  SubscriptionState& operator=(const SubscriptionState&) = delete;

  Bus& bus;
  Inbox& inbox;
};

}  // namespace pongsim::transport
