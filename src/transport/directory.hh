#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/node.hh"
#include "transport/deadline.hh"
#include "transport/inbox.hh"
#include "transport/traffic_report.hh"

namespace pongsim::transport {

using EndpointId = std::array<std::uint8_t, 16>;

/// A publisher or a subscriber of a topic.
struct Endpoint {
  std::string topic;
  std::string type;
  Role role = Role::kPublisher;
  /// Whether it is ours to list: of our partition, and no part of the transport's own dealings.
  bool visible = true;
};

/// What other participants have told of themselves. Any thread may use it.
class Directory {
 public:
  /// @param pid Its process, 0 where it is no pongsim.
  void addParticipant(const ParticipantId& id, int pid, std::vector<std::uint32_t> ports);
  void removeParticipant(const ParticipantId& id);
  void addEndpoint(const EndpointId& id, const Endpoint& endpoint);
  void removeEndpoint(const EndpointId& id);

  /// Takes note of how many endpoints a participant says it has.
  void setCensus(const ParticipantId& id, std::uint32_t endpoints);

  /// Takes note of what a participant says of its traffic; `forgetTraffic` begins anew.
  void setTraffic(const ParticipantId& id, TrafficReport report);
  void forgetTraffic();

  /// Has `tell` called with topic and type of each visible publisher of a topic that others tell of from now on, by the
  /// thread that tells and with this directory locked; empty: nobody, and no call is under way any more.
  void tellOfPublishers(std::function<void(const std::string& topic, const std::string& type)> tell);

  /// Says of an endpoint of ours that it is there or gone, to be warned of others that speak another type.
  void addOwn(const Endpoint& endpoint);
  void removeOwn(const Endpoint& endpoint);

  /// @return The participant's process, 0 where it is not known.
  int pidOf(const ParticipantId& id) const;

  /// @return All visible topics of pongsim processes, sorted by name.
  std::vector<TopicInfo> topics() const;
  /// @return One of them, with its traffic where that was told twice since `forgetTraffic`.
  TopicInfo topic(std::string_view name) const;

  /// @return All services of pongsim processes, sorted by name.
  std::vector<ServiceInfo> services() const;
  ServiceInfo service(std::string_view name) const;

  /// Waits until a participant is known at each of `ports` and all of them have told of all their endpoints.
  /// @return Whether they have; false at `deadline`.
  bool waitForAll(std::span<const std::uint32_t> ports, TimePoint deadline);

  /// Waits until the topic has a visible endpoint of that role.
  bool waitForTopic(std::string_view name, Role role, TimePoint deadline);

  /// @return A number that grows with each thing told.
  std::uint64_t version() const;

 private:
  struct Participant {
    int pid = 0;
    std::vector<std::uint32_t> ports;
    std::optional<std::uint32_t> census;
    std::optional<TrafficReport> firstTraffic;
    TrafficReport traffic;
  };

  bool isListed(const EndpointId& id, const Endpoint& endpoint) const;
  std::optional<TopicInfo::Traffic> trafficOf(const ParticipantId& id, const Endpoint& endpoint) const;
  bool isComplete(std::span<const std::uint32_t> ports) const;
  bool isDuplicate(const EndpointId& id, const Endpoint& endpoint) const;
  bool takesAnyType(const ParticipantId& id, const std::string& topic) const;
  bool takesAnyType(const std::string& topic) const;
  void warnOfType(const Endpoint& own, const EndpointId& otherId, const Endpoint& other);
  void changed();
  int pidOfLocked(const ParticipantId& id) const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t version_ = 0;
  std::map<ParticipantId, Participant> participants_;
  std::map<EndpointId, Endpoint> endpoints_;
  std::multimap<std::string, Endpoint> own_;
  std::function<void(const std::string& topic, const std::string& type)> tell_;
  /// Topic and foreign type of the warnings given.
  std::map<std::string, std::string> warned_;
};

}  // namespace pongsim::transport
