#include <set>
#include <string>

#include "ros2/doctor/checks.hh"
#include "ros2/node/names.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::ros2 {

namespace {

using Verdict = Finding::Verdict;
constexpr std::string_view kDrivers = "Nav2, teleop nodes";
constexpr const char* kTwist = "geometry_msgs/msg/Twist";
constexpr const char* kStamped = "geometry_msgs/msg/TwistStamped";

std::set<std::string> typesOn(const Observation& seen, const std::string& topic, Graph::Role role) {
  std::set<std::string> types;
  for (const Graph::Endpoint& each : seen.endpointsOn(topic, role)) types.insert(rosTypeName(each.contract.type));
  return types;
}

}  // namespace

Findings checkCommands(const Observation& seen, const Expected& expected) {
  const std::string topic = absoluteName(expected.nameSpace, "cmd_vel");
  const std::set<std::string> heard = typesOn(seen, topic, Graph::Role::kReader);
  if (!heard.contains(kTwist) && !heard.contains(kStamped)) {
    return {{Verdict::kFault, "nobody subscribes to '" + topic + "': the robot can't be driven",
             "in the drive's <plugin>: <topic>cmd_vel</topic>", kDrivers}};
  }
  for (const std::string& type : typesOn(seen, topic, Graph::Role::kWriter)) {
    // `checkMatches` says the rest
    if (heard.contains(type) || type != kStamped) continue;
    return {{Verdict::kFault, "commands on '" + topic + "' are stamped, but the robot hears those without stamp",
             "pongsim run WORLD --ros2 --ros2-topic '" + topic + "@" + kStamped + "@ignition.msgs.Twist'", kDrivers}};
  }
  return {{Verdict::kGood, "'" + topic + "' drives the robot", {}, kDrivers}};
}

}  // namespace pongsim::ros2
