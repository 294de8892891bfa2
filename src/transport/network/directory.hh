#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/node.hh"
#include "transport/buffer_pool.hh"
#include "transport/deadline.hh"
#include "transport/locks.hh"
#include "transport/network/traffic_report.hh"

namespace pongsim::transport {

using EndpointId = std::array<std::uint8_t, 16>;

/// A publisher or subscriber of a topic.
struct Endpoint {
  std::string topic;
  std::string type;
  Role role = Role::kPublisher;
  /// Whether it is listed: it is in our partition and not internal to the transport.
  bool visible = true;
};

/// What other participants have announced. Thread-safe.
class Directory {
 public:
  /// @param pid Process id, 0 if it is not a pongsim process.
  /// @param first The network's first participant, which speaks for this one too: it has the census of both and reports
  /// the traffic of both. Nothing: it is the first itself.
  void addParticipant(const ParticipantId& id, int pid, std::vector<std::uint32_t> ports,
                      const std::optional<ParticipantId>& first = std::nullopt);
  void removeParticipant(const ParticipantId& id);
  void addEndpoint(const EndpointId& id, const Endpoint& endpoint);
  void removeEndpoint(const EndpointId& id);

  /// Stores the number of endpoints that a participant claims to have, with those whose first it is.
  void setCensus(const ParticipantId& id, std::uint32_t endpoints);

  /// Stores a participant's traffic report; `forgetTraffic` discards all.
  void setTraffic(const ParticipantId& id, TrafficReport report);
  void forgetTraffic();

  /// Lets `tell` be called with topic and type of each visible publisher announced by others from now on, on the
  /// announcing thread with this directory locked. Empty: no calls any more, and none is running.
  void tellOfPublishers(std::function<void(const std::string& topic, const std::string& type)> tell);

  /// Adds or removes an endpoint of this process, to warn about others with another type, and about a world of the same
  /// name in another process.
  void addOwn(const Endpoint& endpoint);
  void removeOwn(const Endpoint& endpoint);

  /// @return The participant's process id, 0 if unknown.
  int pidOf(const ParticipantId& id) const;

  /// @return All visible topics of pongsim processes, sorted by name.
  std::vector<TopicInfo> topics() const;
  /// @return One topic, with its traffic if it was reported twice since `forgetTraffic`.
  TopicInfo topic(std::string_view name) const;

  /// @return All services of pongsim processes, sorted by name.
  std::vector<ServiceInfo> services() const;
  ServiceInfo service(std::string_view name) const;

  /// Waits until a participant is known at each of `ports` and all have announced all their endpoints.
  /// @return Whether they have; false at `deadline`.
  bool waitForAll(std::span<const std::uint32_t> ports, TimePoint deadline);

  /// Waits until the topic has a visible endpoint with that role.
  bool waitForTopic(std::string_view name, Role role, TimePoint deadline);

  /// @return A number that grows with each announcement.
  std::uint64_t version() const;

 private:
  struct Participant {
    int pid = 0;
    std::optional<ParticipantId> first;
    std::vector<std::uint32_t> ports;
    std::optional<std::uint32_t> census;
    std::optional<TrafficReport> firstTraffic;
    TrafficReport traffic;
  };

  ParticipantId firstOf(const ParticipantId& id) const REQUIRES(mutex_);
  template <class Predicate>
  bool anyOfNetwork(const ParticipantId& id, Predicate predicate) const REQUIRES(mutex_);
  bool isListed(const EndpointId& id, const Endpoint& endpoint) const REQUIRES(mutex_);
  std::optional<TopicInfo::Traffic> trafficOf(const ParticipantId& id, const Endpoint& endpoint) const REQUIRES(mutex_);
  bool isComplete(std::span<const std::uint32_t> ports) const REQUIRES(mutex_);
  bool isDuplicate(const EndpointId& id, const Endpoint& endpoint) const REQUIRES(mutex_);
  bool takesAnyType(const ParticipantId& id, const std::string& topic) const REQUIRES(mutex_);
  bool takesAnyType(const std::string& topic) const REQUIRES(mutex_);
  void warnOfType(const Endpoint& own, const EndpointId& otherId, const Endpoint& other) REQUIRES(mutex_);
  void warnOfWorld(const Endpoint& own, const EndpointId& otherId, const Endpoint& other) REQUIRES(mutex_);
  void changed() REQUIRES(mutex_);
  int pidOfLocked(const ParticipantId& id) const REQUIRES(mutex_);

  mutable Mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t version_ GUARDED_BY(mutex_) = 0;
  std::map<ParticipantId, Participant> participants_ GUARDED_BY(mutex_);
  std::map<EndpointId, Endpoint> endpoints_ GUARDED_BY(mutex_);
  std::map<ParticipantId, std::size_t> endpointsOf_ GUARDED_BY(mutex_);
  std::multimap<std::string, Endpoint> own_ GUARDED_BY(mutex_);
  std::function<void(const std::string& topic, const std::string& type)> tell_ GUARDED_BY(mutex_);
  /// Topic and foreign type of warnings given.
  std::map<std::string, std::string> warned_ GUARDED_BY(mutex_);
};

}  // namespace pongsim::transport
