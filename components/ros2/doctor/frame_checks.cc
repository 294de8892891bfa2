#include <optional>
#include <string>

#include "ros2/doctor/checks.hh"

namespace pongsim::ros2 {

namespace {

using Verdict = Finding::Verdict;
constexpr std::string_view kFrameUsers = "Nav2, slam_toolbox, robot_localization, RViz";
/// Nav2 extrapolates transforms by 0.1 s at most (`transform_tolerance`).
constexpr double kLeastRate = 10;

constexpr const char* kLeaveOut =
    "pongsim run WORLD --ros2-no-link-tf beside robot_state_publisher, or --ros2-no-tf; or end the other node";

void checkParents(const Observation& seen, Findings& findings) {
  bool isGood = true;
  for (const auto& [name, frame] : seen.frames) {
    if (frame.parents.size() > 1) {
      findings.push_back(
          {Verdict::kFault,
           "frame '" + name + "' has " + std::to_string(frame.parents.size()) + " parents: " + quoted(frame.parents),
           kLeaveOut, kFrameUsers});
    } else if (frame.publishers.size() > 1) {
      findings.push_back({Verdict::kFault,
                          "frame '" + name + "' has " + std::to_string(frame.publishers.size()) + " publishers",
                          kLeaveOut, kFrameUsers});
    } else if (rootOf(seen.frames, name).empty()) {
      findings.push_back({Verdict::kFault, "frame '" + name + "' is its own ancestor", kLeaveOut, kFrameUsers});
    } else {
      continue;
    }
    isGood = false;
  }
  if (isGood) findings.push_back({Verdict::kGood, "each frame has one parent and one publisher", {}, kFrameUsers});
}

/// REP 105: map, odom, base_link.
void checkNames(const Observation& seen, const Expected& expected, Findings& findings) {
  const std::string odom = expected.framePrefix + "odom", base = expected.framePrefix + "base_link";
  const std::string map = "map";
  if (!isKnown(seen.frames, base)) {
    findings.push_back({Verdict::kFault, "there is no frame '" + base + "'",
                        "name the robot's main link base_link, and in an SDF one of its links in the drive, "
                        "<child_frame_id>" +
                            base + "</child_frame_id>",
                        kFrameUsers});
  }
  if (!isKnown(seen.frames, odom)) {
    findings.push_back({Verdict::kFault, "there is no frame '" + odom + "'",
                        "in the drive's <plugin>: <frame_id>" + odom + "</frame_id>", kFrameUsers});
    return;
  }
  const std::string root = rootOf(seen.frames, base);
  const bool isBelow = root == rootOf(seen.frames, odom);
  if (isBelow) {
    findings.push_back({Verdict::kGood, "'" + base + "' is below '" + odom + "'", {}, kFrameUsers});
  } else if (isKnown(seen.frames, base)) {
    findings.push_back({Verdict::kFault, "'" + base + "' is not below '" + odom + "', but below '" + root + "'",
                        "in the drive's <plugin>: <child_frame_id> with the name of the robot's root link",
                        kFrameUsers});
  }
  if (!isKnown(seen.frames, map)) {
    findings.push_back({Verdict::kHint, "there is no frame 'map'",
                        "start slam_toolbox, or map_server and amcl, which publish it", "Nav2"});
  }
}

void checkStamps(const Observation& seen, Findings& findings) {
  std::optional<double> slowest;
  for (const auto& [name, frame] : seen.frames) {
    if (frame.isStatic) continue;
    if (frame.stamps.goBack) {
      findings.push_back({Verdict::kFault, "the stamps of frame '" + name + "' go back",
                          "end the second publisher; after a reset, restart nodes that keep transforms", kFrameUsers});
    }
    const std::optional<double> rate = frame.stamps.rate();
    if (!rate) continue;
    slowest = std::min(slowest.value_or(*rate), *rate);
    if (*rate >= kLeastRate) continue;
    findings.push_back({Verdict::kFault,
                        "frame '" + name + "' comes " + rounded(*rate) + " times a second; 10 is the least",
                        "in the drive's <plugin>: <odom_publish_frequency>50</odom_publish_frequency>; for other "
                        "frames <tf_rate> of pongsim-ros2-system",
                        kFrameUsers});
  }
  if (slowest && *slowest >= kLeastRate) {
    findings.push_back(
        {Verdict::kGood, "moving frames come " + rounded(*slowest) + " times a second or more", {}, kFrameUsers});
  }
}

}  // namespace

Findings checkFrames(const Observation& seen, const Expected& expected) {
  if (seen.frames.empty()) {
    return {{Verdict::kFault, "there are no frames on /tf and /tf_static",
             "pongsim run without --ros2-no-tf, or start robot_state_publisher", kFrameUsers}};
  }
  Findings findings;
  checkParents(seen, findings);
  checkNames(seen, expected, findings);
  checkStamps(seen, findings);
  return findings;
}

}  // namespace pongsim::ros2
