#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/log.hh"
#include "ros2/node/complaints.hh"
#include "ros2/node/mailbox.hh"
#include "ros2/node/names.hh"
#include "ros2/node/node_announcement.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/type_info.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

class RosNode;

/// A publisher on a topic. Ends when it is destroyed; must not outlive its node.
class RosPublisher {
 public:
  /// Called from a thread of DDS: whether it is for readers that announce this hash of their type, which is empty for
  /// those of Humble.
  using IsForType = std::function<bool(const std::string& hash)>;
  RosPublisher(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos,
               std::function<void()> readersChanged, const IsForType& isForType = {});
  ~RosPublisher();
  RosPublisher(const RosPublisher&) = delete;
  RosPublisher& operator=(const RosPublisher&) = delete;

  bool hasReaders() const { return writer_->hasReaders(); }
  /// Sends a message of the publisher's type; never blocks.
  template <Structure Message>
  void publish(const Message& message) {
    writer_->write(cdrSize(message), [&message](std::span<std::byte> place) { writeCdr(message, place); });
  }
  Writer& writer() { return *writer_; }
  const Writer& writer() const { return *writer_; }

 private:
  RosNode& node_;
  std::unique_ptr<Writer> writer_;
};

/// A subscription to a topic. Ends when it is destroyed; must not outlive its node.
class RosSubscription {
 public:
  /// @param received Called from a DDS thread with each payload.
  RosSubscription(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos,
                  Reader::Received received);
  ~RosSubscription();
  RosSubscription(const RosSubscription&) = delete;
  RosSubscription& operator=(const RosSubscription&) = delete;

  const Reader& reader() const { return *reader_; }

 private:
  RosNode& node_;
  std::unique_ptr<Reader> reader_;
};

/// A ROS node: its publishers, subscriptions and services, and the announcement that they belong to it.
class RosNode {
 public:
  struct Options {
    std::string name = "pongsim";
    /// "/" or "/robot".
    std::string nameSpace = "/";
    /// Whether nodes that don't announce the hashes of their types, those of Humble, have the older version of
    /// interfaces of which there are two.
    bool prefersOlder = true;
  };

  /// @throws std::invalid_argument for invalid names; std::runtime_error if DDS fails.
  RosNode(Participant& participant, const Options& options);
  /// A node of the same participant as another one, which need not outlive it. Throws likewise.
  RosNode(RosNode& beside, const Options& options);
  ~RosNode();
  RosNode(const RosNode&) = delete;
  RosNode& operator=(const RosNode&) = delete;

  Participant& participant() { return participant_; }
  const Options& options() const { return options_; }
  /// @return "/robot/pongsim".
  std::string fullName() const { return absoluteName(options_.nameSpace, options_.name); }
  const Logger& log() const { return log_; }
  Complaints& complaints() { return complaints_; }

  /// Work queued for the thread that calls `mailbox().dispatch()`: service requests, and what is posted.
  Mailbox& mailbox() { return mailbox_; }

  /// @param topic Relative names are inside the node's namespace, names that start with "~/" inside its own name; the
  /// same below.
  /// @param readersChanged Called from a DDS thread when a reader appears or disappears.
  /// @param isForType Which readers get the messages; empty: all.
  template <Structure Message>
  std::unique_ptr<RosPublisher> advertise(const std::string& topic, const Qos& qos = kDefaultQos,
                                          std::function<void()> readersChanged = {},
                                          const RosPublisher::IsForType& isForType = {}) {
    return std::make_unique<RosPublisher>(*this, topic, typeInfo<Message>(), qos, std::move(readersChanged), isForType);
  }

  /// @param received Called from a DDS thread with each message. Invalid payloads are dropped with a warning.
  template <Structure Message>
  std::unique_ptr<RosSubscription> subscribe(const std::string& topic, std::function<void(const Message&)> received,
                                             const Qos& qos = kAnyWriterQos) {
    return std::make_unique<RosSubscription>(
        *this, topic, typeInfo<Message>(), qos,
        [this, topic, received = std::move(received), message = Message()](const Sample& sample) mutable {
          if (const auto error = readCdr(sample.payload, message)) {
            complainOf(topic, *error);
          } else {
            received(message);
          }
        });
  }

  /// Reports a payload that is not of its topic's type.
  void complainOf(std::string_view topic, std::string_view error);
  /// @return The number of such payloads.
  std::uint64_t malformed() const { return malformed_; }

  /// @return The absolute name.
  std::string resolve(std::string_view name) const;

  /// Remembers a type that the node uses.
  void use(const TypeInfo& type);
  /// @return A type that the node uses or has used; nothing for others.
  std::optional<TypeInfo> usedType(const std::string& name) const;

  /// Announces that an endpoint has been added or removed.
  void addWriter(const Guid& id);
  void removeWriter(const Guid& id);
  void addReader(const Guid& id);
  void removeReader(const Guid& id);

  /// Suspends announcements for its lifetime; then everything is announced at once. For creating many endpoints.
  class Quiet {
   public:
    explicit Quiet(RosNode& node);
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

   private:
    RosNode& node_;
  };

 private:
  RosNode(Participant& participant, std::shared_ptr<NodeAnnouncement> announcement, const Options& options);
  void announce();

  Participant& participant_;
  /// Of all nodes of the participant.
  std::shared_ptr<NodeAnnouncement> announcement_;
  Options options_;
  Logger log_{"ros2"};
  Complaints complaints_;
  Mailbox mailbox_;
  std::atomic<std::uint64_t> malformed_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, TypeInfo> types_;
  int quiet_ = 0;
  std::vector<Guid> writers_;
  std::vector<Guid> readers_;
};

}  // namespace pongsim::ros2
