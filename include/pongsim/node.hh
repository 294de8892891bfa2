#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/bulk.hh"
#include "pongsim/export.hh"
#include "pongsim/message.hh"
#include "pongsim/service.hh"

namespace pongsim {

class Publisher;

namespace transport {
class Bus;
class Channel;
class DispatchQueue;
class GatewayState;
class Inbox;
class PublisherState;
class SubscriptionState;
}  // namespace transport

struct PublisherOptions {
  /// Whether the last message is kept and given to every subscriber that comes later, in this process or another, for
  /// as long as the publisher lives: for what is said once or seldom, such as a scene. It is published then whether
  /// somebody listens or not.
  bool latched = false;
  /// Whether it says here again what was said elsewhere, for who carries messages between this transport and others. It
  /// is no publisher in `ownTopics`, and subscriptions that relay do not hear it: what came by one carrier is carried
  /// on by no other, and never back. Not with `latched`.
  bool relays = false;
  /// Whether the subscriptions of this transport alone hear it, and no other process.
  bool ownOnly = false;
};

struct SubscriptionOptions {
  /// So many messages wait for `dispatch`, at least 1, and 64 MiB of them unless it is a single one. Then the oldest is
  /// dropped and counted.
  std::size_t queueLength = 1000;
  /// So many messages a second of wall time are taken, above 0; those between pass unheard and uncounted. Unset: all.
  /// It is for watching: what a system hears in this way is not the same in each run.
  std::optional<double> messagesPerSecond = std::nullopt;
  /// How large a number with a point (float, double) may be, either way. A message with a larger one, with one that is
  /// not finite, or with a time beyond 4e9 s is refused: a warning says which number and what is allowed, and the
  /// subscription does not hear of it. Unset: all are taken. Not for `subscribeBytes`. See `commands.hh`.
  std::optional<double> largestNumber = std::nullopt;
  /// What this publisher of the same transport sends is not heard: for who both publishes and subscribes on a topic,
  /// and would hear itself. Looked at when the subscription is made; null: all is heard.
  const Publisher* except = nullptr;
  /// Whether it carries elsewhere what it hears: it is no subscription in `ownTopics`, and hears no publisher that
  /// relays.
  bool relays = false;
  /// Whether it hears the publishers of this transport alone, and no other process.
  bool ownOnly = false;
};

/// Called with a message; where some of it is not in it yet, `bulk` says what, else it is null. Both live until it
/// returns.
using HeardAtOnce = std::function<void(const Message& message, const Bulk* bulk)>;

/// Called with how many bytes a message has in protobuf's binary form, and with what writes so many of them, which
/// lives until it returns and may be called once, or not.
using HeardBytesAtOnce = std::function<void(std::size_t size, const std::function<void(std::span<std::byte>)>& write)>;

/// Called with a message in protobuf's binary form and the full name of its type. Both live until it returns.
using ReceivedOfAnyType = std::function<void(std::string_view type, std::span<const std::byte> bytes)>;

/// Publishes messages of one type on one topic, for as long as it lives. It must not outlive its `Transport`.
class PONGSIM_API Publisher {
 public:
  Publisher();
  explicit Publisher(std::unique_ptr<transport::PublisherState> state);
  Publisher(Publisher&&) noexcept;
  Publisher& operator=(Publisher&&) noexcept;
  ~Publisher();

  explicit operator bool() const { return state_ != nullptr; }

  /// @return Whether somebody listens, in this process or another. Cheap: ask before filling in a message.
  bool hasSubscribers() const;

  /// @return How many subscribers have come since this was asked last, or since the topic is there. For what each is to
  /// be told once and is not worth keeping, where `PublisherOptions::latched` would. Not for several threads at once.
  std::uint64_t newSubscribers();

  /// Sends a message to whoever listens now; never waits for them.
  /// @throws std::invalid_argument where the message's type is not the topic's.
  void publish(const Message& message);

  /// As `publish`, a message whose bulk is elsewhere: it is written to where each listener wants it.
  /// @throws std::invalid_argument, too, where the message has no such field of bytes.
  void publish(const Message& message, const Bulk& bulk);

  /// As `publish`, a message in protobuf's binary form. Bytes that are no message of the topic's type are dropped, with
  /// a warning, where somebody reads them as one.
  void publishBytes(std::span<const std::byte> bytes);

  /// @return Messages sent so far. What is published while nobody listens is not sent, unless it is latched.
  std::uint64_t sent() const;

  /// Waits until somebody listens.
  /// @return Whether somebody does; false after `timeout`.
  bool waitForSubscribers(std::chrono::nanoseconds timeout) const;

  /// Waits until every reliable subscriber in another process has acknowledged all messages so far.
  /// @return Whether they have; false after `timeout`.
  bool waitForDelivery(std::chrono::nanoseconds timeout) const;

 private:
  friend class transport::Inbox;
  std::unique_ptr<transport::PublisherState> state_;
};

/// Ends when it is destroyed: its function is not called from then on. It must not outlive its `Transport`.
class PONGSIM_API Subscription {
 public:
  Subscription();
  explicit Subscription(std::unique_ptr<transport::SubscriptionState> state);
  Subscription(Subscription&&) noexcept;
  Subscription& operator=(Subscription&&) noexcept;
  ~Subscription();

  explicit operator bool() const { return state_ != nullptr; }

  /// @return Messages that have come so far, without the dropped ones.
  std::uint64_t received() const;

  /// @return Messages lost so far because `dispatch`, or this process, did not keep up. Of another process's it knows
  /// from the first one on that it has heard; what that process gave up before is in its own count.
  std::uint64_t dropped() const;

 private:
  std::unique_ptr<transport::SubscriptionState> state_;
};

/// What a topic offers in this process and in others.
struct TopicInfo {
  std::string name;
  /// What has passed through the publishers or the subscriptions of a process.
  struct Traffic {
    /// Messages sent or received since the first of them is there.
    std::uint64_t messages = 0;
    /// Messages that some subscriber, or these subscriptions, did not get.
    std::uint64_t dropped = 0;
    /// Messages a second of wall time, while it was watched.
    double rate = 0;
    bool operator==(const Traffic&) const = default;
  };
  struct Endpoint {
    /// Full name of the message type; "*" of a subscriber that takes any and has not met one yet.
    std::string type;
    /// Process that it belongs to, 0 where it is not known.
    int pid = 0;
    /// Known where `Transport::watchTopic` has asked for it, and the process has answered.
    std::optional<Traffic> traffic = std::nullopt;
    bool operator==(const Endpoint&) const = default;
  };
  std::vector<Endpoint> publishers;
  std::vector<Endpoint> subscribers;
};

/// A topic as a transport itself has it: what its own publishers and subscriptions are, without those that relay.
struct OwnTopic {
  std::string name;
  /// Full name of the message type; "*" of subscriptions that take any. A topic with several types is there several
  /// times.
  std::string type;
  int publishers = 0;
  int subscriptions = 0;
  /// Whether one of the publishers keeps the last message for who comes later.
  bool isLatched = false;
  /// Publishers that relay, which are not among those above.
  int relayingPublishers = 0;
  bool operator==(const OwnTopic&) const = default;
};

/// @return What is wrong with `name` as a topic's name ("has a space"), or nothing. Names with a space, `~`,
/// `//`, `@` or `:=`, empty ones and a lone `/` are no topics.
PONGSIM_API std::optional<std::string> topicNameError(std::string_view name);

/// @return A topic's name made of a text in which other names stand, as Fortress does it: spaces become `_`; `@`, `~`,
/// `:=` and `//` are removed.
PONGSIM_API std::string cleanTopic(std::string_view text);

/// Stands around the calls that messages and requests make, to see to what goes wrong in them.
class PONGSIM_API CallGuard {
 public:
  virtual ~CallGuard();
  /// Before each call.
  /// @return Whether to make it.
  virtual bool enter() = 0;
  /// After each call.
  virtual void leave() = 0;
  /// Where the call has thrown, before `leave`.
  virtual void failed(const std::exception& error) = 0;
  /// A topic is advertised.
  virtual void advertised(std::string_view topic, std::string_view type) = 0;
};

/// Speaks on topics and to services. A copy speaks through the same transport.
class PONGSIM_API Node {
 public:
  /// @return A node whose subscriptions and services are called with `guard` around them, which must outlive them.
  Node guardedBy(CallGuard& guard) const;

  /// @return A node whose relative names, "scan", stand for names within `nameSpace`: "/robot/scan". Absolute ones,
  /// with a slash in front, stay as they are.
  /// @throws std::invalid_argument where it can't be part of a name.
  Node within(std::string_view nameSpace) const;

  /// @return As `within`, but absolute names stand for names within `nameSpace`, too, unless they are there already.
  Node below(std::string_view nameSpace) const;

  /// @param topic Relative names get a leading slash, or the node's namespace.
  /// @throws std::invalid_argument for a bad name or an unknown type.
  Publisher advertise(std::string_view topic, std::string_view type, const PublisherOptions& options = {});

  /// As `advertise`, for messages whose type need not be known here: they are published by `publishBytes`.
  Publisher advertiseBytes(std::string_view topic, std::string_view type, const PublisherOptions& options = {});

  /// Calls `received` from within `Transport::dispatch` with each message of that type on the topic, in the order
  /// in which they came. The message lives until `received` returns.
  /// @throws std::invalid_argument for a bad name, an unknown type or a rate that is not above 0.
  Subscription subscribe(std::string_view topic, std::string_view type, std::function<void(const Message&)> received,
                         const SubscriptionOptions& options = {});

  /// As `subscribe`, with the messages as they came, in protobuf's binary form and unchecked. The type need not be
  /// known here.
  Subscription subscribeBytes(std::string_view topic, std::string_view type,
                              std::function<void(std::span<const std::byte>)> received,
                              const SubscriptionOptions& options = {});

  /// As `subscribeBytes`, for messages of every type that is published on the topic, now or later. A publisher of
  /// another process with a type that is new here is heard from the next `Transport::dispatch` on after it is known;
  /// who waits for subscribers waits for that, too. Others see the subscription as one of each type that it has met. It
  /// takes up to 64 types; the options are for each of them.
  Subscription subscribeAnyType(std::string_view topic, ReceivedOfAnyType received,
                                const SubscriptionOptions& options = {});

  /// As `subscribe`, but what the publishers of this transport send is handed over at once, from within their `publish`
  /// and on their thread, in no other form than theirs: nothing is copied, nothing waits. What other processes send,
  /// and what is latched when it is made, comes from within `Transport::dispatch` as ever. `heard` may be called by
  /// several threads, by one at a time. It may publish, and must not make or end publishers and subscriptions. What it
  /// throws a guarded node takes, else who publishes.
  Subscription subscribeAtOnce(std::string_view topic, std::string_view type, HeardAtOnce heard,
                               const SubscriptionOptions& options = {});

  /// As `subscribeAtOnce`, with the messages in protobuf's binary form, written once to where the listener wants them.
  /// The type need not be known here.
  Subscription subscribeBytesAtOnce(std::string_view topic, std::string_view type, HeardBytesAtOnce heard,
                                    const SubscriptionOptions& options = {});

  /// @return The topics of this transport's own publishers and subscriptions, sorted by name, then by type. A
  /// subscription to any type counts for those that it has met, too.
  std::vector<OwnTopic> ownTopics() const;
  /// @return A number that is another one when a publisher or a subscription of this transport has come or gone, but
  /// for those that relay. Cheap: for who watches the topics from step to step.
  std::uint64_t ownTopicsVersion() const;

  /// @return The services that this transport offers itself, sorted by name.
  std::vector<OwnService> ownServices() const;
  /// @return A number that is another one when a service of this transport has come or gone. Cheap.
  std::uint64_t ownServicesVersion() const;

  /// Has `call` asked where a service is called that this transport does not offer itself, for who reaches others:
  /// before other processes of this kind are, and once more where none of them has it.
  Gateway openGateway(CallElsewhere call);

  /// Ends a wait in `Transport::dispatchFor` from any thread, so that a run that is paused calls its systems at once:
  /// for who has something to do there that did not come by a topic or a service.
  void wake();

  /// Offers a service: `handler` is called from within `Transport::dispatch` with each request, after the messages
  /// that came before it. Requests beyond a thousand that wait, or 32 MiB of them, are dropped with a warning.
  /// @param service Relative names get a leading slash, or the node's namespace. A name has up to 230 letters.
  /// Where another transport that shares this one's way offers the name already, that one answers all but this one's
  /// own calls, with a warning, until it is gone.
  /// @throws std::invalid_argument for a bad name, an unknown type, or a name that this transport offers already.
  Service serve(std::string_view service, std::string_view requestType, std::string_view replyType,
                ServiceHandler handler);

  /// Sends a request to a service, of this transport or else of another process, and waits for the answer. A service
  /// of this transport answers when another thread calls `Transport::dispatch`.
  /// @param reply Replaced where the outcome is `kDone`. Its type says which the service must have.
  /// @param timeout For all of it, from finding the service to the answer.
  /// @throws std::invalid_argument for a bad name; std::logic_error if called from a function that `dispatch` called.
  CallResult call(std::string_view service, const Message& request, Message& reply, std::chrono::nanoseconds timeout);

  /// Sends a request to a service of this same transport and does not wait: systems can ask each other in this way, and
  /// a run repeats. The service gets it at the next `Transport::dispatch`, which calls `answered` right after.
  /// @param replyType Which type the service must answer with.
  /// @param answered May be empty.
  /// @return Nothing where this transport has no such service with such types; `answered` is not called then.
  /// @throws std::invalid_argument for a bad name or an unknown type.
  PendingRequest request(std::string_view service, const Message& request, std::string_view replyType,
                         Answered answered);

  template <class M>
  Publisher advertise(std::string_view topic, const PublisherOptions& options = {}) {
    return advertise(topic, M::descriptor()->full_name(), options);
  }
  template <class M>
  Subscription subscribe(std::string_view topic, std::function<void(const M&)> received,
                         const SubscriptionOptions& options = {}) {
    return subscribe(
        topic, M::descriptor()->full_name(),
        [received = std::move(received)](const Message& message) { received(static_cast<const M&>(message)); },
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
  friend class Transport;
  Node(transport::Bus& bus, transport::DispatchQueue& queue) : bus_(&bus), queue_(&queue) {}
  Publisher advertiseOn(transport::Channel& channel, const PublisherOptions& options);

  std::string fullName(std::string_view name) const;

  transport::Bus* bus_;
  transport::DispatchQueue* queue_;
  CallGuard* guard_ = nullptr;
  /// Begins with a slash, or is empty. Ends with one where absolute names are within it, too.
  std::string nameSpace_;
};

struct TransportOptions {
  /// Talk to other processes (over DDS), or only within this `Transport`.
  bool network = true;
  /// DDS domain, 0 to 232; processes of different domains do not see each other. Unset: what the environment
  /// variable PONGSIM_DOMAIN says, else 0.
  std::optional<int> domain = std::nullopt;
  /// Talk to other machines too: by which of this machine's network interfaces, as its name or IPv4 address. Anybody
  /// there can listen, command and stop: nothing is encrypted and nobody is asked who he is. Unset: what the
  /// environment variable PONGSIM_NETWORK says, else none: nothing leaves this machine, 127.0.0.1.
  std::optional<std::string> interface = std::nullopt;
};

/// The way to the topics and services. Makes no thread call user code: messages wait until `dispatch`.
class PONGSIM_API Transport {
 public:
  /// @throws std::runtime_error where the network can't be had, std::invalid_argument for a bad domain or interface.
  explicit Transport(const TransportOptions& options = {});

  struct Sharing {};
  /// One that goes the same way as `other`, as one participant of the network, with a queue of its own: what comes for
  /// its subscriptions and services waits for its own `dispatch`. So that several simulations of a process, each on a
  /// thread of its own, do not wait for each other. They hear each other's topics and call each other's services; what
  /// is said of "this transport's own" is said of each alone.
  Transport(const Transport& other, Sharing);

  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  Node node() { return Node(*bus_, *queue_); }

  /// @return Where it can be reached from other machines, "eth0, 192.0.2.7", or nothing where it can't.
  std::optional<std::string> openTo() const;

  /// Hands the messages that have arrived to their subscriptions, then the requests to their services, on the calling
  /// thread, and returns; what the called functions publish meanwhile waits for the next call. Never blocks.
  /// @return The number of messages and requests handed over.
  std::size_t dispatch();

  /// Waits for messages, up to `timeout`, or until `wake` is called; then does what `dispatch` does.
  std::size_t dispatchFor(std::chrono::nanoseconds timeout);

  /// Ends a wait in `dispatchFor` from any thread.
  void wake();

  /// Waits until the processes that are there now have told of their topics; as long as it takes, up to `timeout`.
  /// @return All topics with a publisher or a subscriber other than this `Transport`'s own, sorted by name.
  std::vector<TopicInfo> discover(std::chrono::nanoseconds timeout);

  /// Waits until the topic has a publisher (or a subscriber) in another process, up to `timeout`.
  /// @return What is known of the topic then.
  TopicInfo waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout);

  /// Asks the processes, for so long, what passes through the topic's publishers and subscriptions.
  /// @return What is known of the topic then, with its traffic.
  TopicInfo watchTopic(std::string_view topic, std::chrono::nanoseconds duration);

  /// As `discover`, for services.
  std::vector<ServiceInfo> discoverServices(std::chrono::nanoseconds timeout);

  /// Waits until another process offers the service, up to `timeout`.
  /// @return What is known of the service then.
  ServiceInfo waitForService(std::string_view service, std::chrono::nanoseconds timeout);

 private:
  std::shared_ptr<transport::Bus> bus_;
  transport::DispatchQueue* queue_;
};

}  // namespace pongsim
