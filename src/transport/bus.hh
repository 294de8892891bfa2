#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "transport/complaint_limit.hh"
#include "transport/dispatch_queue.hh"
#include "transport/inbox.hh"
#include "transport/interfaces.hh"
#include "transport/service_client.hh"
#include "transport/service_server.hh"

namespace pongsim::transport {

class AnyType;
class Network;
class PublisherState;
class Reader;
struct TrafficReport;
class Writer;

/// A topic as one type of message: all publishers and subscriptions of this transport.
class Channel {
 public:
  Channel(std::string topic, std::string type);
  ~Channel();

  const std::string topic;
  const std::string type;

  /// How many use it.
  struct Users {
    int publishers = 0;
    int latchedPublishers = 0;
    int relayingPublishers = 0;
    int ownOnlyPublishers = 0;
    int subscriptions = 0;
    int relayingSubscriptions = 0;
    int ownOnlySubscriptions = 0;
  };
  /// Guarded by the bus's set-up mutex: of all, and of the transports that share the bus, by their queues. The writer
  /// is there while a publisher is that speaks to other processes, the reader while a subscription is that hears them.
  Users users;
  std::map<const DispatchQueue*, Users> usersOf;
  std::unique_ptr<Writer> writer;
  std::unique_ptr<Reader> reader;

  /// Guarded by the bus's mutex, in the order of subscribing; with those that hear at once.
  std::vector<Inbox*> inboxes;
  std::atomic<int> inboxCount = 0;
  std::atomic<std::uint64_t> inboxesSoFar = 0;
  std::atomic<std::uint64_t> sent = 0;

  /// Those that hear at once, who are not in `inboxCount`. Held while they are called, which may publish in turn.
  std::recursive_mutex hearing;
  std::vector<Inbox*> atOnce;
  std::atomic<int> atOnceCount = 0;
  /// Of how many transports they are, and of which if it is one.
  std::atomic<int> atOnceQueues = 0;
  std::atomic<const DispatchQueue*> atOnceQueue = nullptr;
  /// Those of either kind that relay.
  std::atomic<int> relayingCount = 0;
  /// What bytes are read into for them, or null.
  MessagePointer read;

  /// For who comes later, or null; guarded by the bus's mutex.
  Buffer* latched = nullptr;

  /// Of bad messages; guarded by the bus's mutex.
  ComplaintLimit complaints;
};

/// Takes messages from publishers and from the network to the subscriptions of one `Transport`, or of several that
/// share it, each with a queue of its own.
///
/// Three mutexes, taken in this order: `DispatchQueue::dispatching`, `setUp_` (making and ending endpoints), `mutex_`
/// (what waits). DDS threads take only the last, which is therefore never held while DDS is called.
class Bus {
 public:
  /// @param network Null for a transport of this process only.
  explicit Bus(std::unique_ptr<Network> network);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// @return Where it talks to other machines, if it does.
  std::optional<NetworkInterface> interface() const;

  /// @return A queue that stays until the bus ends.
  DispatchQueue& addQueue();

  /// Types are full names, `queue` that of the transport by which it is asked for.
  /// @throws std::invalid_argument for a bad topic name; std::runtime_error where DDS refuses.
  Channel& addPublisher(DispatchQueue& queue, std::string_view topic, const std::string& type,
                        const PublisherOptions& options);
  void endPublisher(DispatchQueue& queue, Channel& channel, const PublisherOptions& options);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                         Inbox::Received received, const SubscriptionOptions& options);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                         Inbox::ReceivedBytes received, const SubscriptionOptions& options);
  /// Of one that hears at once what is published by its own transport.
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type, HeardAtOnce heard,
                         const SubscriptionOptions& options);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type, HeardBytesAtOnce heard,
                         const SubscriptionOptions& options);
  void endSubscription(Inbox& inbox);
  /// Of one that takes messages of any type.
  AnyType& addAnyType(DispatchQueue& queue, std::string_view topic, ReceivedOfAnyType received,
                      const SubscriptionOptions& options);
  void endAnyType(AnyType& any);

  /// Those of the queue's transport.
  std::vector<OwnTopic> ownTopics(const DispatchQueue& queue);

  bool hasSubscribers(const PublisherState& publisher) const;
  std::uint64_t newSubscribers(PublisherState& publisher) const;
  void publish(PublisherState& publisher, const Message& message);
  void publish(PublisherState& publisher, const Message& message, const Bulk& bulk);
  void publishBytes(PublisherState& publisher, std::span<const std::byte> bytes);
  bool waitForSubscribers(const PublisherState& publisher, std::chrono::nanoseconds timeout);
  bool waitForDelivery(const Channel& channel, std::chrono::nanoseconds timeout);
  std::uint64_t received(const Inbox& inbox) const;
  std::uint64_t dropped(const Inbox& inbox) const;
  std::uint64_t received(const AnyType& any) const;
  std::uint64_t dropped(const AnyType& any) const;

  std::size_t dispatch(DispatchQueue& queue);
  std::size_t dispatchFor(DispatchQueue& queue, std::chrono::nanoseconds timeout);
  void wake(DispatchQueue& queue);

  std::vector<TopicInfo> discover(std::chrono::nanoseconds timeout);
  TopicInfo waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout);
  TopicInfo watchTopic(std::string_view topic, std::chrono::nanoseconds duration);

  Offer& addService(DispatchQueue& queue, std::string_view service, std::string_view requestType,
                    std::string_view replyType, ServiceHandler handler);
  void endService(Offer& offer);
  CallResult call(DispatchQueue& queue, std::string_view service, const Message& request, Message& reply,
                  std::chrono::nanoseconds timeout);

  /// Sends a request to a service of this transport.
  /// @return Its number, or nothing where there is no such service.
  std::optional<std::uint64_t> request(DispatchQueue& queue, std::string_view service, const Message& request,
                                       const std::string& replyType, Answered answered) {
    return client_.post(queue, service, request, replyType, std::move(answered));
  }
  /// Does not have the request's function called any more.
  void forgetRequest(std::uint64_t number) { client_.forget(number); }
  /// Those of the queue's transport, sorted by name. Of transports that share the bus the first one tells of those of
  /// the bus's own transport, too: they are there once, and this one is there in their place for who looks for them.
  std::vector<OwnService> ownServices(const DispatchQueue& queue);
  std::uint64_t ownServicesVersion() const { return server_.version(); }
  std::uint64_t addGateway(CallElsewhere call) { return client_.addGateway(std::move(call)); }
  void endGateway(std::uint64_t number) { client_.endGateway(number); }
  std::vector<ServiceInfo> discoverServices(std::chrono::nanoseconds timeout);
  ServiceInfo waitForService(std::string_view service, std::chrono::nanoseconds timeout);

 private:
  Channel& channelFor(std::string_view topic, const std::string& type);
  Inbox& addInbox(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> inbox);
  Inbox& addHearing(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> inbox);
  static void count(Channel& channel, DispatchQueue& queue, const PublisherOptions& publisher, int change);
  static void count(Channel& channel, const Inbox& inbox, int change);
  void openReader(Channel& channel);
  void hear(AnyType& any, const std::string& type);
  void publisherFound(const std::string& topic, const std::string& type);
  void hearFoundTypes();
  bool isAwaited(const PublisherState& publisher) const;
  static bool isFor(const Inbox& inbox, const PublisherState* from);
  static bool isForInboxes(const PublisherState& publisher);
  bool isWantedInBytes(PublisherState& publisher);
  void send(PublisherState& publisher, std::size_t size, const std::function<void(std::span<std::byte>)>& fill);
  void hearAtOnce(PublisherState& publisher, const Message& message, const Bulk* bulk);
  void hearBytesAtOnce(PublisherState& publisher, std::span<const std::byte> bytes);
  static void countAtOnceQueues(Channel& channel);
  /// @param from Null for another process's.
  void deliver(Channel& channel, Buffer* buffer, bool latched, const PublisherState* from);
  void putInto(Inbox& inbox, Buffer* buffer);
  void receive(Channel& channel, const ParticipantId& sender, Buffer& sample);
  void forgetLatched(Channel& channel, const std::function<bool(const ParticipantId& sender)>& isMeant);
  TrafficReport traffic();
  Buffer* takeBuffer(std::size_t size);
  void collectArrivals(DispatchQueue& queue);
  void releaseArrivals(DispatchQueue& queue);
  void eraseIfUnused(const Channel& channel);
  void complain(Channel& channel, const ParticipantId& sender, std::string_view what);
  void subscribersChanged();
  void requestArrived(DispatchQueue& queue);

  /// Before what has threads, which may look at them; guarded by the set-up mutex.
  std::vector<std::unique_ptr<DispatchQueue>> queues_;

  std::unique_ptr<Network> network_;

  std::mutex setUp_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<Channel>> channels_;

  /// With their topics; changed with both `setUp_` and `mutex_` held.
  std::vector<std::unique_ptr<AnyType>> anyTypes_;
  /// Publishers that other processes turned out to have on such topics, guarded by `mutex_`: topic and type.
  std::vector<std::pair<std::string, std::string>> foundTypes_;

  mutable std::mutex mutex_;
  std::condition_variable subscribersChanged_;
  std::map<Inbox*, std::unique_ptr<Inbox>> inboxes_;
  BufferPool buffers_;
  std::vector<Buffer*> dropped_;
  std::uint64_t nextArrival_ = 0;

  ServiceServer server_;
  ServiceClient client_;
};

/// A publisher's share in its topic.
class PublisherState {
 public:
  PublisherState(Bus& owner, DispatchQueue& asker, Channel& topic, const PublisherOptions& given)
      : bus(owner), queue(asker), channel(topic), options(given) {}
  ~PublisherState() { bus.endPublisher(queue, channel, options); }
  PublisherState(const PublisherState&) = delete;
  PublisherState& operator=(const PublisherState&) = delete;

  Bus& bus;
  DispatchQueue& queue;
  Channel& channel;
  const PublisherOptions options;
  std::atomic<std::uint64_t> sent = 0;
  /// Subscribers that it has been told of.
  std::uint64_t knownSubscribers = 0;
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

/// The right of a request to have its function called.
class RequestState {
 public:
  RequestState(Bus& owner, std::uint64_t request) : bus(owner), number(request) {}
  ~RequestState() { bus.forgetRequest(number); }
  RequestState(const RequestState&) = delete;
  RequestState& operator=(const RequestState&) = delete;

  Bus& bus;
  const std::uint64_t number;
};

/// A gateway's share in its transport.
class GatewayState {
 public:
  GatewayState(Bus& owner, std::uint64_t gateway) : bus(owner), number(gateway) {}
  ~GatewayState() { bus.endGateway(number); }
  GatewayState(const GatewayState&) = delete;
  GatewayState& operator=(const GatewayState&) = delete;

  Bus& bus;
  const std::uint64_t number;
};

/// A subscription's place to wait for messages, or its places where it takes any type.
class SubscriptionState {
 public:
  SubscriptionState(Bus& bus, Inbox& inbox) : bus_(bus), place_(&inbox) {}
  SubscriptionState(Bus& bus, AnyType& any) : bus_(bus), place_(&any) {}
  ~SubscriptionState();
  SubscriptionState(const SubscriptionState&) = delete;
  SubscriptionState& operator=(const SubscriptionState&) = delete;

  std::uint64_t received() const;
  std::uint64_t dropped() const;

 private:
  Bus& bus_;
  std::variant<Inbox*, AnyType*> place_;
};

}  // namespace pongsim::transport
