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
#include "transport/channel.hh"
#include "transport/dispatch_queue.hh"
#include "transport/inbox.hh"
#include "transport/services/service_client.hh"
#include "transport/services/service_server.hh"
#include "transport/udp/interfaces.hh"

namespace pongsim::transport {

class AnyType;
class Network;
class PublisherState;
struct TrafficReport;

/// Delivers messages from publishers and the network to the subscriptions of one `Transport`, or of several that share
/// it, each with its own queue.
///
/// Three mutexes, locked in this order: `DispatchQueue::dispatching`, `setUp_` (adding and removing endpoints),
/// `mutex_` (waiting messages). DDS threads lock only the last, which is therefore never held while DDS is called.
class Bus {
 public:
  /// @param network Null for a transport within this process.
  explicit Bus(std::unique_ptr<Network> network);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// @return The network interface for other machines, if any.
  std::optional<NetworkInterface> interface() const;

  /// @return A queue that exists as long as the bus.
  DispatchQueue& addQueue();

  /// Types are full names; `queue` is that of the calling transport.
  /// @throws std::invalid_argument for an invalid topic name; std::runtime_error if DDS refuses.
  Channel& addPublisher(DispatchQueue& queue, std::string_view topic, const std::string& type,
                        const PublisherOptions& options);
  void endPublisher(DispatchQueue& queue, Channel& channel, const PublisherOptions& options);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                         Inbox::Received received, const SubscriptionOptions& options);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                         Inbox::ReceivedBytes received, const SubscriptionOptions& options);
  /// A subscription that receives messages of its own transport within `publish`.
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type, HeardAtOnce heard,
                         const SubscriptionOptions& options);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type, HeardBytesAtOnce heard,
                         const SubscriptionOptions& options);
  void endSubscription(Inbox& inbox);
  /// A subscription to messages of any type.
  AnyType& addAnyType(DispatchQueue& queue, std::string_view topic, ReceivedOfAnyType received,
                      const SubscriptionOptions& options);
  void endAnyType(AnyType& any);

  /// The topics of the queue's transport.
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

  void announce();
  std::vector<TopicInfo> discover(std::chrono::nanoseconds timeout);
  bool heardAll() const { return heardAll_; }
  TopicInfo waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout);
  TopicInfo watchTopic(std::string_view topic, std::chrono::nanoseconds duration);

  Offer& addService(DispatchQueue& queue, std::string_view service, std::string_view requestType,
                    std::string_view replyType, ServiceHandler handler);
  void endService(Offer& offer);
  CallResult call(DispatchQueue& queue, std::string_view service, const Message& request, Message& reply,
                  std::chrono::nanoseconds timeout);

  /// Sends a request to a service of this transport.
  /// @return Its number; nothing if there is no such service.
  std::optional<std::uint64_t> request(DispatchQueue& queue, std::string_view service, const Message& request,
                                       const std::string& replyType, Answered answered) {
    return client_.post(queue, service, request, replyType, std::move(answered));
  }
  /// Cancels the call of the request's function.
  void forgetRequest(std::uint64_t number) { client_.forget(number); }
  /// The services of the queue's transport, sorted by name. Of transports that share the bus, the first one also lists
  /// those of the bus's own transport: they exist once, and this transport represents it to others.
  std::vector<OwnService> ownServices(const DispatchQueue& queue);
  std::uint64_t ownServicesVersion() const { return server_.version(); }
  std::uint64_t addGateway(CallElsewhere call) { return client_.addGateway(std::move(call)); }
  void endGateway(std::uint64_t number) { client_.endGateway(number); }
  std::vector<ServiceInfo> discoverServices(std::chrono::nanoseconds timeout);
  ServiceInfo waitForService(std::string_view service, std::chrono::nanoseconds timeout);

 private:
  Channel& channelFor(std::string_view topic, const std::string& type);
  template <class Add>
  auto& inChannel(std::string_view topic, const std::string& type, const Add& add);
  Inbox& addInbox(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> inbox);
  void giveBackUnread(Inbox& inbox);
  Inbox& addHearing(DispatchQueue& queue, Channel& channel, std::unique_ptr<Inbox> inbox);
  void openReader(Channel& channel);
  std::vector<std::string> typesOn(const std::string& topic) const;
  void endAnnouncement(AnyType& any);
  std::unique_ptr<AnyType> takeAnyType(const AnyType& any);
  void hear(AnyType& any, const std::string& type) noexcept;
  void addInboxOf(AnyType& any, const std::string& type);
  void publisherFound(const std::string& topic, const std::string& type);
  void hearFoundTypes(DispatchQueue& queue);
  bool isAwaited(const PublisherState& publisher) const;
  static bool isFor(const Inbox& inbox, const PublisherState* from);
  bool isWantedInBytes(PublisherState& publisher);
  void send(PublisherState& publisher, std::size_t size, const std::function<void(std::span<std::byte>)>& fill);
  void hearAtOnce(PublisherState& publisher, const Message& message, const Bulk* bulk);
  void hearBytesAtOnce(PublisherState& publisher, std::span<const std::byte> bytes);
  /// @param from Null for another process.
  void deliver(Channel& channel, Buffer* buffer, bool latched, const PublisherState* from);
  void putInto(Inbox& inbox, Buffer* buffer);
  void receive(Channel& channel, const ParticipantId& sender, Buffer& sample);
  void forgetLatched(Channel& channel, const std::function<bool(const ParticipantId& sender)>& isMeant);
  TrafficReport traffic();
  Buffer* takeBuffer(std::size_t size);
  void collectArrivals(DispatchQueue& queue);
  void releaseArrivals(DispatchQueue& queue);
  void endUnused(Channel& channel);
  void complain(Channel& channel, const ParticipantId& sender, std::string_view what);
  void subscribersChanged();
  void requestArrived(DispatchQueue& queue);

  /// Declared before members with threads that may access it. Guarded by the set-up mutex.
  std::vector<std::unique_ptr<DispatchQueue>> queues_;

  std::unique_ptr<Network> network_;

  std::mutex setUp_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<Channel>> channels_;

  /// Changed with both `setUp_` and `mutex_` held.
  std::vector<std::unique_ptr<AnyType>> anyTypes_;
  /// Topic and type of publishers found in other processes on such topics. Guarded by `mutex_`.
  std::vector<std::pair<std::string, std::string>> foundTypes_;

  mutable std::mutex mutex_;
  std::condition_variable subscribersChanged_;
  std::map<Inbox*, std::unique_ptr<Inbox>> inboxes_;
  BufferPool buffers_;
  std::vector<Buffer*> dropped_;
  std::uint64_t nextArrival_ = 0;
  std::atomic<bool> heardAll_ = true;

  ServiceServer server_;
  ServiceClient client_;
};

/// @return What `add` has added to the channel of a topic; if it throws, the channel goes too, unless it is used. With
/// the set-up mutex held.
template <class Add>
auto& Bus::inChannel(std::string_view topic, const std::string& type, const Add& add) {
  Channel& channel = channelFor(topic, type);
  try {
    return add(channel);
  } catch (...) {
    endUnused(channel);
    throw;
  }
}

/// State of a publisher.
class PublisherState {
 public:
  /// Adds it.
  PublisherState(Bus& owner, DispatchQueue& asker, std::string_view topic, const std::string& type,
                 const PublisherOptions& given)
      : bus(owner), queue(asker), channel(owner.addPublisher(asker, topic, type, given)), options(given) {}
  ~PublisherState() { bus.endPublisher(queue, channel, options); }
  PublisherState(const PublisherState&) = delete;
  PublisherState& operator=(const PublisherState&) = delete;

  Bus& bus;
  DispatchQueue& queue;
  Channel& channel;
  const PublisherOptions options;
  std::atomic<std::uint64_t> sent = 0;
  /// Subscribers reported so far.
  std::uint64_t knownSubscribers = 0;
};

/// State of a service.
class ServiceState {
 public:
  /// Adds it.
  ServiceState(Bus& owner, DispatchQueue& queue, std::string_view service, std::string_view requestType,
               std::string_view replyType, ServiceHandler handler)
      : bus(owner), offer(owner.addService(queue, service, requestType, replyType, std::move(handler))) {}
  ~ServiceState() { bus.endService(offer); }
  ServiceState(const ServiceState&) = delete;
  ServiceState& operator=(const ServiceState&) = delete;

  Bus& bus;
  Offer& offer;
};

/// State of a pending request.
class RequestState {
 public:
  explicit RequestState(Bus& owner) : bus(owner) {}
  ~RequestState() {
    if (number) bus.forgetRequest(*number);
  }
  RequestState(const RequestState&) = delete;
  RequestState& operator=(const RequestState&) = delete;

  Bus& bus;
  std::optional<std::uint64_t> number;
};

/// State of a gateway.
class GatewayState {
 public:
  /// Adds it.
  GatewayState(Bus& owner, CallElsewhere call) : bus(owner), number(owner.addGateway(std::move(call))) {}
  ~GatewayState() { bus.endGateway(number); }
  GatewayState(const GatewayState&) = delete;
  GatewayState& operator=(const GatewayState&) = delete;

  Bus& bus;
  const std::uint64_t number;
};

/// State of a subscription: its inbox, or that of any type.
class SubscriptionState {
 public:
  /// Adds it.
  template <class Received>
  SubscriptionState(Bus& bus, DispatchQueue& queue, std::string_view topic, const std::string& type, Received received,
                    const SubscriptionOptions& options)
      : bus_(bus), place_(&bus.addSubscription(queue, topic, type, std::move(received), options)) {}
  SubscriptionState(Bus& bus, DispatchQueue& queue, std::string_view topic, ReceivedOfAnyType received,
                    const SubscriptionOptions& options)
      : bus_(bus), place_(&bus.addAnyType(queue, topic, std::move(received), options)) {}
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
