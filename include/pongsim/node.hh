#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/message.hh"

namespace pongsim {

namespace transport {
class Bus;
class PublisherState;
class SubscriptionState;
}  // namespace transport

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

  /// Sends a message to whoever listens now; never waits for them. The message's type must be the topic's.
  void publish(const Message& message);

  /// Waits until somebody listens.
  /// @return Whether somebody does; false after `timeout`.
  bool waitForSubscribers(std::chrono::nanoseconds timeout) const;

  /// Waits until every reliable subscriber in another process has acknowledged all messages so far.
  /// @return Whether they have; false after `timeout`.
  bool waitForDelivery(std::chrono::nanoseconds timeout) const;

 private:
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

  /// @return Messages thrown away since the start because `dispatch` did not keep up.
  std::uint64_t dropped() const;

 private:
  std::unique_ptr<transport::SubscriptionState> state_;
};

/// What a topic offers in this process and in others.
struct TopicInfo {
  std::string name;
  struct Endpoint {
    /// Full name of the message type.
    std::string type;
    /// Process that it belongs to, 0 where it is not known.
    int pid = 0;
    bool operator==(const Endpoint&) const = default;
  };
  std::vector<Endpoint> publishers;
  std::vector<Endpoint> subscribers;
};

/// @return What is wrong with `name` as a topic's name ("has a space"), or nothing. Names with a space, `~`,
/// `//`, `@` or `:=`, empty ones and a lone `/` are no topics.
PONGSIM_API std::optional<std::string> topicNameError(std::string_view name);

/// @return A topic's name made of a text in which other names stand, as Fortress does it: spaces become `_`; `@`, `~`,
/// `:=` and `//` are removed.
PONGSIM_API std::string cleanTopic(std::string_view text);

/// Speaks on topics: advertises and subscribes. A copy speaks through the same transport.
class PONGSIM_API Node {
 public:
  /// @param topic Relative names get a leading slash.
  /// @throws std::invalid_argument for a bad name or an unknown type.
  Publisher advertise(std::string_view topic, std::string_view type);

  /// Calls `received` from within `Transport::dispatch` with each message of that type on the topic, in the order
  /// in which they came. The message lives until `received` returns. Up to `queueLength` messages wait for
  /// `dispatch`; then the oldest is dropped and counted.
  /// @throws std::invalid_argument for a bad name or an unknown type.
  Subscription subscribe(std::string_view topic, std::string_view type, std::function<void(const Message&)> received,
                         std::size_t queueLength = 1000);

  template <class M>
  Publisher advertise(std::string_view topic) {
    return advertise(topic, M::descriptor()->full_name());
  }
  template <class M>
  Subscription subscribe(std::string_view topic, std::function<void(const M&)> received,
                         std::size_t queueLength = 1000) {
    return subscribe(
        topic, M::descriptor()->full_name(),
        [received = std::move(received)](const Message& message) { received(static_cast<const M&>(message)); },
        queueLength);
  }

 private:
  friend class Transport;
  explicit Node(transport::Bus& bus) : bus_(&bus) {}
  transport::Bus* bus_;
};

struct TransportOptions {
  /// Talk to other processes (over DDS on 127.0.0.1), or only within this `Transport`.
  bool network = true;
  /// DDS domain, 0 to 232; processes of different domains do not see each other. Unset: what the environment
  /// variable PONGSIM_DOMAIN says, else 0.
  std::optional<int> domain = std::nullopt;
};

/// The way to the topics. Makes no thread call user code: messages wait until `dispatch`.
class PONGSIM_API Transport {
 public:
  /// @throws std::runtime_error where the network can't be had, std::invalid_argument for a bad domain.
  explicit Transport(const TransportOptions& options = {});
  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  Node node() { return Node(*bus_); }

  /// Hands the messages that have arrived to their subscriptions, on the calling thread, and returns; what the
  /// called functions publish meanwhile waits for the next call. Never blocks.
  /// @return The number of messages handed over.
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

 private:
  std::unique_ptr<transport::Bus> bus_;
};

}  // namespace pongsim
