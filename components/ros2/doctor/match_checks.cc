#include <set>
#include <string>

#include "ros2/doctor/checks.hh"
#include "ros2/node/names.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::ros2 {

namespace {

using Verdict = Finding::Verdict;

/// What keeps a reader from a writer on its topic, and what mends it.
struct Obstacle {
  std::string reason;
  std::string remedy;
};

Obstacle obstacleBetween(const Contract& writer, const Contract& reader) {
  if (writer.type != reader.type) {
    return {"as " + rosTypeName(reader.type) + ", but it is published as " + rosTypeName(writer.type),
            "the same type on both sides, as by --ros2-topic NAME@ROS_TYPE@IGNITION_TYPE"};
  }
  if (reader.qos.isReliable && !writer.qos.isReliable) {
    return {"reliably, but it is published best effort", "subscribe with qos_profile_sensor_data"};
  }
  if (reader.qos.isTransientLocal && !writer.qos.isTransientLocal) {
    return {"for earlier messages (transient local), but its publisher keeps none",
            "subscribe with durability volatile"};
  }
  if (reader.hasDeadline) return {"with a deadline, which nobody promises", "subscribe without deadline"};
  if (reader.hasLiveliness) return {"with a liveliness, which nobody promises", "subscribe with liveliness automatic"};
  return {};
}

}  // namespace

Findings checkMatches(const Observation& seen) {
  Findings findings;
  std::set<std::string> said;
  for (const Graph::Endpoint& reader : seen.endpoints) {
    const auto topic = topicFromWire(reader.contract.topic);
    if (reader.role != Graph::Role::kReader || !topic) continue;
    for (const Graph::Endpoint& writer : seen.endpointsOn(*topic, Graph::Role::kWriter)) {
      if (rosTypeName(writer.contract.type).empty()) continue;
      const Obstacle obstacle = obstacleBetween(writer.contract, reader.contract);
      const std::string text = "a subscriber wants '" + *topic + "' " + obstacle.reason + " (" +
                               seen.nodesThat(&NodeInfo::subscribes, *topic) + ")";
      if (obstacle.reason.empty() || !said.insert(text).second) continue;
      findings.push_back({Verdict::kFault, text + ": nothing arrives", obstacle.remedy, "that node"});
    }
  }
  if (findings.empty()) {
    findings.push_back(
        {Verdict::kGood, "publishers and subscribers agree on types and quality of service", {}, "all nodes"});
  }
  return findings;
}

}  // namespace pongsim::ros2
