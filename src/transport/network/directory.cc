#include "transport/network/directory.hh"

#include <algorithm>

#include "pongsim/log.hh"
#include "transport/names/service_name.hh"
#include "transport/names/type_name.hh"

namespace pongsim::transport {

namespace {

ParticipantId participantOf(const EndpointId& endpoint) {
  ParticipantId id{};
  std::copy_n(endpoint.begin(), id.size(), id.begin());
  return id;
}

/// The lowest id of an endpoint that a participant can have.
EndpointId lowestOf(const ParticipantId& participant) {
  EndpointId id{};
  std::ranges::copy(participant, id.begin());
  return id;
}

const EndpointTraffic* trafficIn(const TrafficReport& report, const Endpoint& endpoint) {
  const auto found = std::ranges::find_if(report.endpoints, [&](const EndpointTraffic& each) {
    return each.topic == endpoint.topic && each.type == endpoint.type && each.role == endpoint.role;
  });
  return found == report.endpoints.end() ? nullptr : &*found;
}

/// @return The name of the world whose control is requested on a topic; empty if it is another topic.
std::string_view controlledWorld(std::string_view topic) {
  constexpr std::string_view kBegin = "/world/", kEnd = "/control";
  std::string_view name = serviceOfRequestTopic(topic).value_or(std::string_view{});
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd) || name.size() <= kBegin.size() + kEnd.size()) return {};
  name.remove_prefix(kBegin.size());
  name.remove_suffix(kEnd.size());
  return name.find('/') == std::string_view::npos ? name : std::string_view{};
}

}  // namespace

void Directory::changed() {
  ++version_;
  changed_.notify_all();
}

void Directory::addParticipant(const ParticipantId& id, int pid, std::vector<std::uint32_t> ports,
                               const std::optional<ParticipantId>& first) {
  const Lock lock(mutex_);
  Participant& participant = participants_[id];
  participant.pid = pid;
  participant.first = first;
  participant.ports = std::move(ports);
  changed();
}

void Directory::removeParticipant(const ParticipantId& id) {
  const Lock lock(mutex_);
  participants_.erase(id);
  auto endpoint = endpoints_.lower_bound(lowestOf(id));
  while (endpoint != endpoints_.end() && participantOf(endpoint->first) == id) endpoint = endpoints_.erase(endpoint);
  endpointsOf_.erase(id);
  changed();
}

void Directory::addEndpoint(const EndpointId& id, const Endpoint& endpoint) {
  const Lock lock(mutex_);
  const bool isNew = endpoints_.insert_or_assign(id, endpoint).second;
  if (isNew) ++endpointsOf_[participantOf(id)];
  const auto [begin, end] = own_.equal_range(endpoint.topic);
  for (auto own = begin; own != end; ++own) {
    warnOfType(own->second, id, endpoint);
    if (isNew) warnOfWorld(own->second, id, endpoint);
  }
  if (tell_ && endpoint.role == Role::kPublisher && endpoint.visible && endpoint.topic.starts_with('/')) {
    tell_(endpoint.topic, endpoint.type);
  }
  changed();
}

void Directory::tellOfPublishers(std::function<void(const std::string& topic, const std::string& type)> tell) {
  const Lock lock(mutex_);
  tell_ = std::move(tell);
}

void Directory::removeEndpoint(const EndpointId& id) {
  const Lock lock(mutex_);
  if (endpoints_.erase(id) > 0) --endpointsOf_[participantOf(id)];
  changed();
}

void Directory::setCensus(const ParticipantId& id, std::uint32_t endpoints) {
  const Lock lock(mutex_);
  participants_[id].census = endpoints;
  changed();
}

void Directory::setTraffic(const ParticipantId& id, TrafficReport report) {
  const Lock lock(mutex_);
  const auto participant = participants_.find(id);
  if (participant == participants_.end()) return;
  if (!participant->second.firstTraffic) participant->second.firstTraffic = report;
  participant->second.traffic = std::move(report);
}

void Directory::forgetTraffic() {
  const Lock lock(mutex_);
  for (auto& [id, participant] : participants_) participant.firstTraffic.reset();
}

void Directory::addOwn(const Endpoint& endpoint) {
  const Lock lock(mutex_);
  const auto added = own_.emplace(endpoint.topic, endpoint);
  try {
    for (const auto& [id, other] : endpoints_) {
      if (other.topic != endpoint.topic) continue;
      warnOfType(endpoint, id, other);
      warnOfWorld(endpoint, id, other);
    }
  } catch (...) {
    own_.erase(added);
    throw;
  }
}

void Directory::removeOwn(const Endpoint& endpoint) {
  const Lock lock(mutex_);
  const auto [begin, end] = own_.equal_range(endpoint.topic);
  const auto found = std::find_if(begin, end, [&](const auto& own) {
    return own.second.type == endpoint.type && own.second.role == endpoint.role;
  });
  if (found != end) own_.erase(found);
}

void Directory::warnOfType(const Endpoint& own, const EndpointId& otherId, const Endpoint& other) {
  // a service's caller learns of the types in its reply
  if (serviceOfRequestTopic(own.topic)) return;
  if (!isListed(otherId, other) || other.type == own.type || other.role == own.role) return;
  const ParticipantId participant = participantOf(otherId);
  if (other.role == Role::kPublisher ? takesAnyType(own.topic) : takesAnyType(participant, own.topic)) return;
  if (std::string& warned = warned_[own.topic]; warned == other.type) return;
  warned_[own.topic] = other.type;
  const std::string process = std::to_string(pidOfLocked(participant));
  static const Logger log("transport");
  log.warning(other.role == Role::kPublisher
                  ? "topic '" + own.topic + "': the types differ: process " + process + " publishes " + other.type +
                        ", this process subscribes to " + own.type
                  : "topic '" + own.topic + "': the types differ: process " + process + " subscribes to " + other.type +
                        ", this process publishes " + own.type);
}

void Directory::warnOfWorld(const Endpoint& own, const EndpointId& otherId, const Endpoint& other) {
  if (own.role != Role::kSubscriber || other.role != Role::kSubscriber || !other.visible) return;
  const std::string world(controlledWorld(own.topic));
  if (world.empty()) return;
  const int pid = pidOfLocked(participantOf(otherId));
  static const Logger log("transport");
  log.warning((pid != 0 ? "process " + std::to_string(pid) : "another process") + " runs a world '" + world +
              "', too: both answer its services, and their topics mix; start one with another PONGSIM_DOMAIN or "
              "IGN_PARTITION, or rename its world");
}

ParticipantId Directory::firstOf(const ParticipantId& id) const {
  const auto found = participants_.find(id);
  return found == participants_.end() ? id : found->second.first.value_or(id);
}

/// @return Whether it holds for one of the endpoints of the participants that have the same first.
template <class Predicate>
bool Directory::anyOfNetwork(const ParticipantId& id, Predicate predicate) const {
  const ParticipantId first = firstOf(id);
  return std::ranges::any_of(participants_, [&](const auto& participant) REQUIRES(mutex_) {
    const ParticipantId& each = participant.first;
    if (firstOf(each) != first) return false;
    for (auto at = endpoints_.lower_bound(lowestOf(each)); at != endpoints_.end(); ++at) {
      if (participantOf(at->first) != each) return false;
      if (predicate(at->first, at->second)) return true;
    }
    return false;
  });
}

/// @return Whether a participant's network has a subscription to any type on the topic.
bool Directory::takesAnyType(const ParticipantId& id, const std::string& topic) const {
  return anyOfNetwork(
      id, [&](const EndpointId&, const Endpoint& each) { return each.topic == topic && each.type == kAnyType; });
}

/// @return Whether this process has one.
bool Directory::takesAnyType(const std::string& topic) const {
  const auto [begin, end] = own_.equal_range(topic);
  return std::any_of(begin, end, [](const auto& own) { return own.second.type == kAnyType; });
}

/// @return Whether it is a subscription to any type that is listed already, for it has met one.
bool Directory::isDuplicate(const EndpointId& id, const Endpoint& endpoint) const {
  if (endpoint.type != kAnyType) return false;
  return anyOfNetwork(participantOf(id), [&](const EndpointId& otherId, const Endpoint& other) {
    return otherId != id && other.topic == endpoint.topic && other.role == endpoint.role;
  });
}

int Directory::pidOfLocked(const ParticipantId& id) const {
  const auto found = participants_.find(id);
  return found == participants_.end() ? 0 : found->second.pid;
}

int Directory::pidOf(const ParticipantId& id) const {
  const Lock lock(mutex_);
  return pidOfLocked(id);
}

std::vector<TopicInfo> Directory::topics() const {
  const Lock lock(mutex_);
  std::map<std::string, TopicInfo> byName;
  for (const auto& [id, endpoint] : endpoints_) {
    if (!isListed(id, endpoint) || !endpoint.topic.starts_with('/') || isDuplicate(id, endpoint)) continue;
    TopicInfo& info = byName[endpoint.topic];
    auto& side = endpoint.role == Role::kPublisher ? info.publishers : info.subscribers;
    side.push_back({endpoint.type, pidOfLocked(participantOf(id)), std::nullopt});
  }
  std::vector<TopicInfo> all;
  for (auto& [name, info] : byName) {
    info.name = name;
    all.push_back(std::move(info));
  }
  return all;
}

TopicInfo Directory::topic(std::string_view name) const {
  const Lock lock(mutex_);
  TopicInfo info{std::string(name), {}, {}};
  for (const auto& [id, endpoint] : endpoints_) {
    if (endpoint.topic != name || !isListed(id, endpoint) || isDuplicate(id, endpoint)) continue;
    const ParticipantId participant = participantOf(id);
    auto& side = endpoint.role == Role::kPublisher ? info.publishers : info.subscribers;
    side.push_back({endpoint.type, pidOfLocked(participant), trafficOf(participant, endpoint)});
  }
  return info;
}

std::optional<TopicInfo::Traffic> Directory::trafficOf(const ParticipantId& id, const Endpoint& endpoint) const {
  const auto participant = participants_.find(firstOf(id));
  if (participant == participants_.end() || !participant->second.firstTraffic) return std::nullopt;
  const TrafficReport& first = *participant->second.firstTraffic;
  const TrafficReport& last = participant->second.traffic;
  // in floating point: others may report any times, whose difference may overflow an integer
  const auto watched = std::chrono::duration<double>(last.at) - std::chrono::duration<double>(first.at);
  const EndpointTraffic* now = trafficIn(last, endpoint);
  if (now == nullptr || watched.count() <= 0) return std::nullopt;
  const EndpointTraffic* before = trafficIn(first, endpoint);
  const std::uint64_t earlier = before == nullptr ? 0 : before->messages;
  const std::uint64_t since = now->messages < earlier ? 0 : now->messages - earlier;
  return TopicInfo::Traffic{now->messages, now->dropped, static_cast<double>(since) / watched.count()};
}

std::vector<ServiceInfo> Directory::services() const {
  const Lock lock(mutex_);
  std::map<std::string_view, ServiceInfo> byName;
  for (const auto& [id, endpoint] : endpoints_) {
    const auto name = serviceOfRequestTopic(endpoint.topic);
    const auto types = typesOfService(endpoint.type);
    // a subscriber of the request topic offers the service
    if (!name || !types || endpoint.role != Role::kSubscriber || !isListed(id, endpoint)) continue;
    byName[*name].providers.push_back(
        {std::string(types->first), std::string(types->second), pidOfLocked(participantOf(id))});
  }
  std::vector<ServiceInfo> all;
  for (auto& [name, info] : byName) {
    info.name = name;
    all.push_back(std::move(info));
  }
  return all;
}

ServiceInfo Directory::service(std::string_view name) const {
  for (ServiceInfo& info : services()) {
    if (info.name == name) return std::move(info);
  }
  return {std::string(name), {}};
}

bool Directory::isListed(const EndpointId& id, const Endpoint& endpoint) const {
  return endpoint.visible && pidOfLocked(participantOf(id)) != 0;
}

bool Directory::isComplete(std::span<const std::uint32_t> ports) const {
  const auto isKnown = [this](std::uint32_t port) REQUIRES(mutex_) {
    return std::ranges::any_of(participants_, [port](const auto& participant) {
      return std::ranges::find(participant.second.ports, port) != participant.second.ports.end();
    });
  };
  if (!std::ranges::all_of(ports, isKnown)) return false;

  std::map<ParticipantId, std::size_t> told;
  for (const auto& [id, endpoints] : endpointsOf_) told[firstOf(id)] += endpoints;
  return std::ranges::all_of(participants_, [&](const auto& participant) REQUIRES(mutex_) {
    // another program has no census, and its topics are not listed
    const auto& [id, about] = participant;
    if (about.pid == 0) return true;
    if (about.first) return participants_.contains(*about.first);
    return about.census && told[id] >= *about.census;
  });
}

bool Directory::waitForAll(std::span<const std::uint32_t> ports, TimePoint deadline) {
  Lock lock(mutex_);
  return changed_.wait_until(lock, deadline, [&]() REQUIRES(mutex_) { return isComplete(ports); });
}

bool Directory::waitForTopic(std::string_view name, Role role, TimePoint deadline) {
  Lock lock(mutex_);
  return changed_.wait_until(lock, deadline, [&]() REQUIRES(mutex_) {
    return std::ranges::any_of(endpoints_, [&](const auto& endpoint) REQUIRES(mutex_) {
      const auto& [id, about] = endpoint;
      return about.role == role && about.topic == name && isListed(id, about);
    });
  });
}

std::uint64_t Directory::version() const {
  const Lock lock(mutex_);
  return version_;
}

}  // namespace pongsim::transport
