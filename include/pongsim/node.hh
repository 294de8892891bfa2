#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pongsim/bulk.hh"
#include "pongsim/export.hh"
#include "pongsim/message.hh"
#include "pongsim/service.hh"

namespace pongsim {

class Interception;
class Publisher;

namespace transport {
class AnyType;
class Bus;
class DispatchQueue;
class Gate;
class Inbox;
class InputGate;
struct PublisherState;
}  // namespace transport

struct PublisherOptions {
  /// Whether the last message is kept and sent to later subscribers, in this process or others, as long as the
  /// publisher exists. For messages that are sent once or seldom, such as a scene. They are published even without
  /// subscribers.
  bool latched = false;
  /// Whether it republishes messages from elsewhere, for carriers between this transport and others. It then is not a
  /// publisher in `ownTopics`, and relaying subscriptions do not receive its messages, so that carriers do not carry
  /// each other's messages and nothing loops. Not with `latched`.
  bool relays = false;
  /// Whether only subscriptions of this transport receive its messages, and no other process.
  bool ownOnly = false;
};

struct SubscriptionOptions {
  /// Most messages that wait for `dispatch`, at least 1; their total size is limited to 64 MiB unless it is a single
  /// message. Then the oldest is dropped and counted.
  std::size_t queueLength = 1000;
  /// Largest magnitude of floating-point numbers. A message with a larger one, one that is not finite, or a time beyond
  /// 4e9 s is refused with a warning that names the number and the limit. Unset: all are accepted. Not for
  /// `subscribeBytes`. See `commands.hh`.
  std::optional<double> largestNumber = std::nullopt;
  /// A publisher of the same transport whose messages are not received: for code that publishes and subscribes on the
  /// same topic. Evaluated when the subscription is made; null: none.
  const Publisher* except = nullptr;
  /// Whether it carries messages elsewhere: it then is not a subscription in `ownTopics`, and does not receive from
  /// relaying publishers.
  bool relays = false;
  /// Whether it receives only from publishers of this transport, and from no other process.
  bool ownOnly = false;
};

/// Called with a message; if a part of it is not in it yet, `bulk` has that part, otherwise it is null. Both are valid
/// during the call.
using HeardAtOnce = std::function<void(const Message& message, const Bulk* bulk)>;

/// Called with the size of a message in protobuf's binary form, and a function that writes it, which is valid during
/// the call and may be called at most once.
using HeardBytesAtOnce = std::function<void(std::size_t size, const std::function<void(std::span<std::byte>)>& write)>;

/// Called with a message in protobuf's binary form and the full name of its type. Both are valid during the call.
using ReceivedOfAnyType = std::function<void(std::string_view type, std::span<const std::byte> bytes)>;

/// Publishes messages of one type on one topic, as long as it exists. Must not outlive its `Transport`.
class PONGSIM_API Publisher {
 public:
  Publisher() = default;

  explicit operator bool() const { return state_ != nullptr; }

  /// @return Whether there are subscribers, in this process or others. Cheap: ask before filling in a message.
  bool hasSubscribers() const;

  /// @return The number of subscribers that were added since the last call, or since the topic exists. For sending each
  /// a message that is not worth keeping with `PublisherOptions::latched`. Not thread-safe.
  std::uint64_t newSubscribers();

  /// Sends a message to the current subscribers without waiting for them.
  /// @throws std::invalid_argument if the message is not of the topic's type.
  void publish(const Message& message);

  /// Like `publish`, for a message with its bulk kept outside, which is written directly to each subscriber's
  /// destination.
  /// @throws std::invalid_argument also if the message has no such `bytes` field.
  void publish(const Message& message, const Bulk& bulk);

  /// Like `publish`, for a message in protobuf's binary form. Bytes that are not a message of the topic's type are
  /// dropped with a warning when a subscription parses them.
  void publishBytes(std::span<const std::byte> bytes);

  /// @return Messages sent so far. Without subscribers, only latched messages are sent.
  std::uint64_t sent() const;

  /// Waits for a subscriber.
  /// @return Whether there is one; false after `timeout`.
  bool waitForSubscribers(std::chrono::nanoseconds timeout) const;

  /// Waits until every reliable subscriber in other processes has acknowledged all messages so far.
  /// @return Whether they have; false after `timeout`.
  bool waitForDelivery(std::chrono::nanoseconds timeout) const;

 private:
  friend class Interception;
  friend class Node;
  friend class transport::Inbox;
  struct PONGSIM_API End {
    void operator()(transport::PublisherState* state) const;
  };
  explicit Publisher(transport::PublisherState* state) : state_(state) {}

  std::unique_ptr<transport::PublisherState, End> state_;
};

/// A subscription, until it is destroyed: its function is not called afterwards. Must not outlive its `Transport`.
class PONGSIM_API Subscription {
 public:
  Subscription() = default;

  explicit operator bool() const { return bus_ != nullptr; }

  /// @return Messages received so far, without dropped ones.
  std::uint64_t received() const;

  /// @return Messages lost so far because `dispatch`, or this process, was too slow. Losses from another process are
  /// counted after its first received message; what that process dropped before is in its own count.
  std::uint64_t dropped() const;

 private:
  friend class Node;
  /// What is ended: a subscription to one type, or to any type.
  struct PONGSIM_API End {
    transport::Inbox* inbox;
    transport::AnyType* any;
    void operator()(transport::Bus* bus) const;
  };
  Subscription(transport::Bus& bus, const End& end) : bus_(&bus, end) {}
  template <class Count>
  std::uint64_t sum(const Count& count) const;

  std::unique_ptr<transport::Bus, End> bus_;
};

/// A topic in this process and others.
struct TopicInfo {
  std::string name;
  /// Traffic of a process's publishers or subscriptions.
  struct Traffic {
    /// Messages sent or received since the first of them exists.
    std::uint64_t messages = 0;
    /// Messages that some subscriber, or these subscriptions, did not get.
    std::uint64_t dropped = 0;
    /// Messages per second of wall time while it was watched.
    double rate = 0;
    bool operator==(const Traffic&) const = default;
  };
  struct Endpoint {
    /// Full name of the message type; "*" for a subscriber of any type that has not met one yet.
    std::string type;
    /// Process id, 0 if unknown.
    int pid = 0;
    /// Known if requested with `Transport::watchTopic` and reported by the process.
    std::optional<Traffic> traffic = std::nullopt;
    bool operator==(const Endpoint&) const = default;
  };
  std::vector<Endpoint> publishers;
  std::vector<Endpoint> subscribers;
};

/// A topic of a transport's own publishers and subscriptions, without relaying ones.
struct OwnTopic {
  std::string name;
  /// Full name of the message type; "*" for subscriptions to any type. A topic with several types has several entries.
  std::string type;
  int publishers = 0;
  int subscriptions = 0;
  /// Whether a publisher keeps the last message for later subscribers.
  bool isLatched = false;
  /// Relaying publishers, which are not included above.
  int relayingPublishers = 0;
  bool operator==(const OwnTopic&) const = default;
};

/// @return What is wrong with `name` as a topic name ("has a space"), or nothing. Not allowed are spaces, `~`, `//`,
/// `@`, `:=`, empty names and a single `/`.
PONGSIM_API std::optional<std::string> topicNameError(std::string_view name);

/// @return A valid topic name made from a text, as in Fortress: spaces become `_`; `@`, `~`, `:=` and `//` are removed.
PONGSIM_API std::string cleanTopic(std::string_view text);

/// Makes the calls of message and service functions, to handle their failures.
class PONGSIM_API CallGuard {
 public:
  /// When a function is called: by `Transport::dispatch`, or, if it hears at once, by `Publisher::publish`, on any
  /// thread and maybe within another guard's call.
  enum class Moment { kDispatch, kPublish };

  virtual ~CallGuard();
  /// Calls `function(data)`, or leaves it out. Throws nothing.
  virtual void call(Moment moment, void (*function)(void* data), void* data) = 0;
  /// Called when a topic is advertised.
  virtual void advertised(std::string_view topic, std::string_view type) = 0;
  /// Whether its functions belong to a simulated world, whose inputs can be recorded and replayed.
  virtual bool isOfWorld() const { return false; }
  /// Whether the calling thread is in a function of that world: what is published or requested there comes again by
  /// itself when the world is replayed.
  virtual bool isActing() const { return false; }

  /// The same for a function object.
  template <class Function>
  void call(Moment moment, Function&& function) {
    using Plain = std::remove_cvref_t<Function>;
    call(
        moment, [](void* data) { (*static_cast<Plain*>(data))(); }, const_cast<Plain*>(&function));
  }
};

/// Access to topics and services. Copies use the same transport.
class PONGSIM_API Node {
 public:
  /// @return A node whose subscriptions and services are wrapped by `guard`, which must outlive them.
  Node guardedBy(CallGuard& guard) const;

  /// @return A node that resolves relative names in a namespace: "scan" becomes "/robot/scan". Absolute names, with a
  /// leading slash, stay as they are.
  /// @throws std::invalid_argument if it can't be part of a name.
  Node within(std::string_view nameSpace) const;

  /// @return Like `within`, but absolute names are put into the namespace too, unless they are already in it.
  Node below(std::string_view nameSpace) const;

  /// @param topic Relative names get a leading slash, or the node's namespace.
  /// @throws std::invalid_argument for an invalid name or an unknown type.
  Publisher advertise(std::string_view topic, std::string_view type, const PublisherOptions& options = {});

  /// Like `advertise`, for messages of a type that need not be known here; use `publishBytes`.
  Publisher advertiseBytes(std::string_view topic, std::string_view type, const PublisherOptions& options = {});

  /// Calls `received` within `Transport::dispatch` with each message of that type on the topic, in the order of
  /// arrival. The message is valid during the call.
  /// @throws std::invalid_argument for an invalid name or an unknown type.
  Subscription subscribe(std::string_view topic, std::string_view type, std::function<void(const Message&)> received,
                         const SubscriptionOptions& options = {});

  /// Like `subscribe`, with unchecked messages in protobuf's binary form. The type need not be known here.
  Subscription subscribeBytes(std::string_view topic, std::string_view type,
                              std::function<void(std::span<const std::byte>)> received,
                              const SubscriptionOptions& options = {});

  /// Like `subscribeBytes`, for messages of every type that is published on the topic, now or later. If another process
  /// publishes a type that is new here, its messages are received from the next `Transport::dispatch` on; a publisher
  /// that waits for subscribers waits for that too. To others, the subscription is one for each type that it has met.
  /// At most 64 types; the options apply to each of them.
  Subscription subscribeAnyType(std::string_view topic, ReceivedOfAnyType received,
                                const SubscriptionOptions& options = {});

  /// Like `subscribe`, but messages of this transport's publishers are passed on immediately, within `publish` and on
  /// its thread, without copying or queueing. Messages of other processes, and latched ones when it is made, arrive
  /// within `Transport::dispatch` as usual. `heard` may be called by several threads, but only one at a time. It may
  /// publish and end its own subscription, but must not create or destroy other publishers and subscriptions. Its
  /// exceptions go to the guard, or to the publisher without one.
  Subscription subscribeAtOnce(std::string_view topic, std::string_view type, HeardAtOnce heard,
                               const SubscriptionOptions& options = {});

  /// Like `subscribeAtOnce`, with messages in protobuf's binary form, written once to where the subscriber wants them.
  /// The type need not be known here.
  Subscription subscribeBytesAtOnce(std::string_view topic, std::string_view type, HeardBytesAtOnce heard,
                                    const SubscriptionOptions& options = {});

  /// @return The topics of this transport's own publishers and subscriptions, sorted by name, then by type. A
  /// subscription to any type also counts for the types that it has met.
  std::vector<OwnTopic> ownTopics() const;
  /// @return A number that changes when a publisher or subscription of this transport is added or removed, except
  /// relaying ones. Cheap: for watching the topics in each step.
  std::uint64_t ownTopicsVersion() const;

  /// @return Why a subscription of this transport to that topic would refuse the message
  /// (`SubscriptionOptions::largestNumber`): "linear.x is nan; ..."; nothing if none would.
  std::optional<std::string> refusal(std::string_view topic, const Message& message) const;

  /// @return The services offered by this transport, sorted by name.
  std::vector<OwnService> ownServices() const;
  /// @return A number that changes when a service of this transport is added or removed. Cheap.
  std::uint64_t ownServicesVersion() const;

  /// Lets `call` handle calls to services that this transport does not offer: it is asked before other pongsim
  /// processes, and once more if none of them has the service.
  Gateway openGateway(CallElsewhere call);

  /// Ends a wait in `Transport::dispatchFor` from any thread, so that a paused run calls its systems immediately. For
  /// work that did not arrive by a topic or service.
  void wake();

  /// Offers a service: `handler` is called within `Transport::dispatch` with each request, after the messages that
  /// arrived before it. More than 1000 waiting requests, or 32 MiB of them, are dropped with a warning.
  /// @param service Relative names get a leading slash, or the node's namespace. At most 230 characters. If another
  /// transport that shares this one's participant already offers the name, that one answers all calls but this
  /// transport's own, with a warning, until it ends.
  /// @throws std::invalid_argument for an invalid name, an unknown type, or a name already offered by this transport.
  Service serve(std::string_view service, std::string_view requestType, std::string_view replyType,
                ServiceHandler handler);

  /// Calls a service of this transport or another process, and waits for the response. A service of this transport
  /// responds when another thread calls `Transport::dispatch`.
  /// @param reply Replaced if the outcome is `kDone`. Its type selects the service's response type.
  /// @param timeout For everything, from finding the service to the response.
  /// @throws std::invalid_argument for an invalid name; std::logic_error if called within `dispatch`.
  CallResult call(std::string_view service, const Message& request, Message& reply, std::chrono::nanoseconds timeout);

  /// Sends a request to a service of this transport without waiting: with it systems can call each other reproducibly.
  /// The service receives it in the next `Transport::dispatch`, which calls `answered` right afterwards.
  /// @param replyType The service's response type.
  /// @param answered May be empty.
  /// @return Nothing if this transport has no such service with these types; then `answered` is not called.
  /// @throws std::invalid_argument for an invalid name or an unknown type.
  PendingRequest request(std::string_view service, const Message& request, std::string_view replyType,
                         Answered answered);

  template <class M>
  Publisher advertise(std::string_view topic, const PublisherOptions& options = {}) {
    return advertise(topic, M::descriptor()->full_name(), options);
  }
  template <class M, class Received>
  Subscription subscribe(std::string_view topic, Received received, const SubscriptionOptions& options = {}) {
    return subscribe(
        topic, M::descriptor()->full_name(),
        [received = std::move(received)](const Message& message) mutable { received(static_cast<const M&>(message)); },
        options);
  }
  template <class Request, class Reply>
  Service serve(std::string_view service, std::function<ServiceAnswer(const Request&, Reply&)> handler) {
    return serve(service, Request::descriptor()->full_name(), Reply::descriptor()->full_name(),
                 [handler = std::move(handler)](const Message& request, Message& reply) {
                   return handler(static_cast<const Request&>(request), static_cast<Reply&>(reply));
                 });
  }

 private:
  friend class Interception;
  friend class Transport;
  Node(transport::Bus& bus, transport::DispatchQueue& queue) : bus_(&bus), queue_(&queue) {}
  Publisher advertiseAs(const std::string& type, std::string_view topic, const PublisherOptions& options);

  std::string fullName(std::string_view name) const;

  transport::Bus* bus_;
  transport::DispatchQueue* queue_;
  CallGuard* guard_ = nullptr;
  /// Begins with a slash, or is empty. Ends with one if absolute names are in it too.
  std::string nameSpace_;
};

struct TransportOptions {
  /// Communicate with other processes (over DDS), or only within this `Transport`.
  bool network = true;
  /// DDS domain, 0 to 232; processes in different domains do not see each other. Unset: the environment variable
  /// PONGSIM_DOMAIN, else 0.
  std::optional<int> domain = std::nullopt;
  /// Also communicate with other machines, over this network interface (name or IPv4 address). Anybody on that network
  /// can then listen and send commands, since nothing is encrypted or authenticated unless secured. Unset: the
  /// environment variable PONGSIM_NETWORK, else none: only 127.0.0.1.
  std::optional<std::string> interface = std::nullopt;
  /// Others do not learn of this `Transport` before `announce`, or before it looks for them, or for a second. Finding
  /// many publishers and services together costs others far less than finding each as it is made.
  bool announceLater = false;
};

/// Connection to topics and services. Does not call user code from its own threads: messages wait for `dispatch`.
class PONGSIM_API Transport {
 public:
  /// @throws std::runtime_error if the network can't be opened, std::invalid_argument for an invalid domain or
  /// interface.
  explicit Transport(const TransportOptions& options = {});

  struct Sharing {};
  /// Shares the network participant of `other`, with its own queue: messages for its subscriptions and services wait
  /// for its own `dispatch`. With it, several simulations of a process, each on its own thread, do not wait for each
  /// other. They receive each other's topics and can call each other's services; "this transport's own" refers to each
  /// separately.
  Transport(const Transport& other, Sharing);

  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// Lets others learn of this transport now, if `TransportOptions::announceLater` has put it off.
  void announce();

  Node node() { return Node(*bus_, *queue_); }

  /// @return Where other machines can reach it, "eth0, 192.0.2.7"; nothing if they can't.
  std::optional<std::string> openTo() const;

  /// Passes received messages to their subscriptions, then requests to their services, on the calling thread. Messages
  /// published meanwhile wait for the next call. Never blocks.
  /// @return The number of messages and requests handled.
  /// @throws What a called function without a guard has thrown, after all others were called. Of several exceptions it
  /// throws the first; the others are logged.
  std::size_t dispatch();

  /// Drops the messages that wait for `dispatch`, and the requests made with `Node::request`, whose `answered` is
  /// called. Latched messages stay, because they hold until the next one, and so do requests from elsewhere, whose
  /// callers wait. For a simulation that is reset or restored: what was sent before belongs to the time before.
  void discard();

  /// Waits for messages, up to `timeout` or until `wake` is called; then does the same as `dispatch`.
  std::size_t dispatchFor(std::chrono::nanoseconds timeout);

  /// Ends a wait in `dispatchFor` from any thread.
  void wake();

  /// Waits until the currently running processes have reported their topics, up to `timeout`.
  /// @return All topics with a publisher or subscriber other than this `Transport`'s own, sorted by name.
  std::vector<TopicInfo> discover(std::chrono::nanoseconds timeout);

  /// @return Whether all processes of this machine had answered when `discover` or `discoverServices` last returned:
  /// false where one is stopped or too busy, and what was returned may lack what it offers. True before, and where
  /// other machines take part, of which nobody knows who should answer.
  bool heardAll() const;

  /// Waits until the topic has a publisher (or subscriber) in another process, up to `timeout`.
  /// @return The topic as known then.
  TopicInfo waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout);

  /// Asks processes about the traffic of the topic's publishers and subscriptions, for `duration`.
  /// @return The topic as known then, with its traffic.
  TopicInfo watchTopic(std::string_view topic, std::chrono::nanoseconds duration);

  /// Like `discover`, for services.
  std::vector<ServiceInfo> discoverServices(std::chrono::nanoseconds timeout);

  /// Waits until another process offers the service, up to `timeout`.
  /// @return The service as known then.
  ServiceInfo waitForService(std::string_view service, std::chrono::nanoseconds timeout);

 private:
  friend class transport::Gate;
  friend class transport::InputGate;

  std::shared_ptr<transport::Bus> bus_;
  transport::DispatchQueue* queue_;
};

}  // namespace pongsim
