#include "ros2/node/node_watch.hh"

#include <algorithm>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "ros2/node/names.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/rmw_dds_common.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::ros2 {

namespace {

constexpr std::string_view kActionPart = "/_action/", kGoal = "/_action/send_goal";
constexpr std::string_view kTypeRequestEnd = "_Request", kGoalEnd = "_SendGoal";
constexpr std::chrono::milliseconds kPollInterval{50};
// Participants answer within a few milliseconds, and repeat lost announcements twice a second: after this time without
// an announcement all are known.
constexpr std::chrono::milliseconds kQuiet{700};

template <std::size_t GidSize>
Guid guidOf(const rmw_dds_common::Gid<GidSize>& gid) {
  Guid guid;
  std::copy_n(gid.data.begin(), guid.bytes.size(), guid.bytes.begin());
  return guid;
}

std::string without(std::string text, std::string_view end) {
  if (text.ends_with(end)) text.resize(text.size() - end.size());
  return text;
}

/// Adds an offered or called service. The goal service of an action represents the action; its other services are
/// skipped.
void addService(const std::string& name, std::string type, std::vector<NodeInfo::Interface>& services,
                std::vector<NodeInfo::Interface>& actions) {
  type = without(std::move(type), kTypeRequestEnd);
  if (name.ends_with(kGoal)) {
    actions.push_back({without(name, kGoal), without(type, kGoalEnd)});
  } else if (name.find(kActionPart) == std::string::npos) {
    services.push_back({name, type});
  }
}

void addEndpoint(const Graph::Endpoint& endpoint, NodeInfo& node) {
  const bool isWriter = endpoint.role == Graph::Role::kWriter;
  std::string type = rosTypeName(endpoint.contract.type);
  if (const auto topic = topicFromWire(endpoint.contract.topic)) {
    if (topic->find(kActionPart) != std::string::npos) return;
    (isWriter ? node.publishes : node.subscribes).push_back({*topic, std::move(type)});
  } else if (const auto service = serviceFromWire(endpoint.contract.topic)) {
    // readers of requests are servers
    addService(*service, std::move(type), isWriter ? node.calls : node.serves,
               isWriter ? node.callsActions : node.servesActions);
  }
}

void sortUnique(std::vector<NodeInfo::Interface>& interfaces) {
  std::ranges::sort(interfaces);
  interfaces.erase(std::unique(interfaces.begin(), interfaces.end()), interfaces.end());
}

}  // namespace

std::string NodeInfo::fullName() const { return absoluteName(nameSpace, name); }

NodeWatch::NodeWatch(Participant& participant) : participant_(participant) {
  const TypeInfo type = typeInfo<rmw_dds_common::ParticipantEntitiesInfo<rmw_dds_common::kJazzyGid>>();
  const Contract contract{kDiscoveryTopic, ddsTypeName(type.name), type.hash, kLatchedQos};
  reader_ = participant_.makeReader(contract, [this](const Sample& sample) {
    // the layout changed when hashes came
    const auto writer = participant_.graph().find(sample.id.writer);
    if (!writer) return;
    writer->contract.typeHash.empty() ? receive<rmw_dds_common::kHumbleGid>(sample)
                                      : receive<rmw_dds_common::kJazzyGid>(sample);
  });
}

NodeWatch::~NodeWatch() = default;

template <std::size_t GidSize>
void NodeWatch::receive(const Sample& sample) {
  rmw_dds_common::ParticipantEntitiesInfo<GidSize> info;
  // damaged
  if (readCdr(sample.payload, info)) return;
  std::vector<Announced> nodes;
  for (const auto& each : info.node_entities_info_seq) {
    Announced& node = nodes.emplace_back();
    node.nameSpace = each.node_namespace;
    node.name = each.node_name;
    for (const auto* gids : {&each.reader_gid_seq, &each.writer_gid_seq}) {
      for (const auto& gid : *gids) node.endpoints.push_back(guidOf(gid));
    }
  }
  const std::lock_guard lock(mutex_);
  announced_[guidOf(info.gid)] = std::move(nodes);
  ++version_;
}

void NodeWatch::settle(std::chrono::nanoseconds timeout) const {
  using Clock = std::chrono::steady_clock;
  const auto versions = [this] {
    const std::lock_guard lock(mutex_);
    return std::pair(version_, participant_.graph().version());
  };
  const Clock::time_point end = Clock::now() + timeout;
  auto last = versions();
  for (Clock::time_point since = Clock::now(); Clock::now() < end && Clock::now() - since < kQuiet;) {
    std::this_thread::sleep_for(kPollInterval);
    if (const auto now = versions(); now != last) {
      last = now;
      since = Clock::now();
    }
  }
}

std::vector<NodeInfo> NodeWatch::nodes() const {
  std::map<Guid, Graph::Endpoint> endpoints;
  for (Graph::Endpoint& each : participant_.graph().endpoints()) endpoints.emplace(each.id, std::move(each));
  const std::vector<Guid> participants = participant_.graph().participants();
  std::vector<NodeInfo> nodes;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [participant, all] : announced_) {
      if (std::ranges::find(participants, participant) == participants.end()) continue;
      for (const Announced& announced : all) {
        NodeInfo& node = nodes.emplace_back();
        node.nameSpace = announced.nameSpace;
        node.name = announced.name;
        for (const Guid& id : announced.endpoints) {
          if (const auto found = endpoints.find(id); found != endpoints.end()) addEndpoint(found->second, node);
        }
      }
    }
  }
  for (NodeInfo& node : nodes) {
    for (auto* interfaces :
         {&node.publishes, &node.subscribes, &node.serves, &node.calls, &node.servesActions, &node.callsActions}) {
      sortUnique(*interfaces);
    }
  }
  std::ranges::sort(nodes, {}, &NodeInfo::fullName);
  return nodes;
}

}  // namespace pongsim::ros2
