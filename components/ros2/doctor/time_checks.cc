#include <string>

#include "ros2/doctor/checks.hh"

namespace pongsim::ros2 {

namespace {
using Verdict = Finding::Verdict;
constexpr const char* kClockTopic = "/clock";
constexpr std::string_view kClockUsers = "all nodes with use_sim_time";
}  // namespace

Findings checkTime(const Observation& seen) {
  Findings findings;
  const std::size_t clocks = seen.endpointsOn(kClockTopic, Graph::Role::kWriter).size();
  if (clocks == 0) {
    findings.push_back({Verdict::kFault, "nobody publishes /clock", "pongsim run WORLD --ros2", kClockUsers});
  } else if (seen.clock.count < 2 || seen.clock.last <= seen.clock.first) {
    findings.push_back({Verdict::kFault, "/clock stands still: the simulation is paused",
                        "resume it: pongsim service -s /world/WORLD/control --req 'pause: false'",
                        kClockUsers});
  } else {
    findings.push_back({Verdict::kGood, "/clock moves", {}, kClockUsers});
  }
  if (clocks > 1) {
    findings.push_back(
        {Verdict::kFault,
         std::to_string(clocks) + " publishers of /clock: " + seen.nodesThat(&NodeInfo::publishes, kClockTopic),
         "end all but one simulation, or give each a ROS_DOMAIN_ID of its own", kClockUsers});
  } else if (seen.clock.goBack) {
    findings.push_back({Verdict::kHint, "/clock went back: the simulation was reset",
                        "restart nodes that keep old data", kClockUsers});
  }
  for (const std::string& node : seen.onWallTime) {
    findings.push_back({Verdict::kFault, "node '" + node + "' runs on wall time, so that all messages are old for it",
                        "start it with --ros-args -p use_sim_time:=true", "the node itself"});
  }
  return findings;
}

}  // namespace pongsim::ros2
