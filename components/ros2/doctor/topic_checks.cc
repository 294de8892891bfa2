#include <algorithm>
#include <optional>
#include <string>

#include "ros2/doctor/checks.hh"
#include "ros2/node/names.hh"

namespace pongsim::ros2 {

namespace {

using Verdict = Finding::Verdict;
constexpr const char* kScan = "sensor_msgs/msg/LaserScan";
constexpr const char* kOdometry = "nav_msgs/msg/Odometry";
constexpr const char* kImage = "sensor_msgs/msg/Image";
constexpr const char* kInfo = "sensor_msgs/msg/CameraInfo";
constexpr const char* kJoints = "sensor_msgs/msg/JointState";
/// Stamps that are farther from the clock are of another clock [s].
constexpr double kSameClock = 5;

/// A topic that tools have by default.
struct Wanted {
  const char* name;
  const char* type;
  std::string_view users;
  /// In Hz; fewer messages are too few for them.
  double leastRate;
  const char* nameRemedy;
  const char* rateRemedy;
};

constexpr Wanted kWanted[] = {
    {"scan", kScan, "Nav2, slam_toolbox", 1, "in the lidar's <sensor>: <topic>scan</topic>",
     "in the lidar's <sensor>: <update_rate>10</update_rate>"},
    {"odom", kOdometry, "Nav2, robot_localization", 10, "in the drive's <plugin>: <odom_topic>odom</odom_topic>",
     "in the drive's <plugin>: <odom_publish_frequency>50</odom_publish_frequency>"},
};

std::string listOf(const std::vector<std::string>& names) {
  return quoted(std::set<std::string>(names.begin(), names.end()));
}

void checkWanted(const Observation& seen, const Wanted& wanted, const std::string& topic, Findings& findings) {
  const std::vector<std::string> others = seen.topicsOf(wanted.type);
  const std::string named = "'" + topic + "' [" + wanted.type + "]";
  if (std::ranges::find(others, topic) == others.end()) {
    findings.push_back(
        {Verdict::kFault, "nobody publishes " + named + (others.empty() ? "" : "; there is " + listOf(others)),
         std::string(wanted.nameRemedy) + (others.empty() ? "" : ", or remap the topic in the node"), wanted.users});
    return;
  }
  const auto stream = seen.streams.find(topic);
  if (stream == seen.streams.end()) return;
  const std::optional<double> rate = stream->second.stamps.rate();
  if (rate && *rate < wanted.leastRate) {
    findings.push_back(
        {Verdict::kFault,
         named + " comes " + rounded(*rate) + " times a second; " + rounded(wanted.leastRate) + " is the least",
         wanted.rateRemedy, wanted.users});
  } else if (rate) {
    findings.push_back({Verdict::kGood, named + " comes " + rounded(*rate) + " times a second", {}, wanted.users});
  }
}

/// One publisher, and messages with stamps of the simulated clock.
void checkStream(const Observation& seen, const std::string& topic, Findings& findings) {
  const std::size_t publishers = seen.endpointsOn(topic, Graph::Role::kWriter).size();
  if (publishers > 1) {
    findings.push_back(
        {Verdict::kFault,
         "'" + topic + "' has " + std::to_string(publishers) +
             " publishers: " + seen.nodesThat(&NodeInfo::publishes, topic),
         "give each its own topic" +
             std::string(topic.ends_with("/joint_states") ? ", or pongsim run --ros2-no-joint-states" : ""),
         "all subscribers"});
  }
  const auto found = seen.streams.find(topic);
  const bool moves = seen.clock.last > seen.clock.first;
  if (found == seen.streams.end()) {
    if (moves) {
      findings.push_back({Verdict::kHint, "nothing came on '" + topic + "'",
                          "watch longer (--time 10), or see what the simulation warns of its sensor",
                          "all subscribers"});
    }
    return;
  }
  const Stamps& stamps = found->second.stamps;
  if (moves && std::abs(stamps.last - seen.clock.last) > kSameClock) {
    findings.push_back({Verdict::kFault,
                        "the stamps of '" + topic + "' are not of /clock: " + rounded(stamps.last) + " s, not " +
                            rounded(seen.clock.last) + " s",
                        "leave out --ros2-override-timestamps; give the publishing node use_sim_time",
                        "all subscribers"});
  }
  if (publishers == 1 && stamps.goBack) {
    findings.push_back({Verdict::kHint, "the stamps of '" + topic + "' went back: the simulation was reset",
                        "restart nodes that keep old data", "all subscribers"});
  }
}

/// Messages are of use if tf knows where they are.
void checkFrame(const Observation& seen, const Expected& expected, const std::string& topic, const StreamSeen& stream,
                Findings& findings) {
  const std::string odom = expected.framePrefix + "odom";
  // nodes transform readings into odom, and odometry is in it
  const bool isOdometry = stream.type == kOdometry;
  for (const std::string& frame : stream.frames) {
    const std::string here = "'" + topic + "' is in frame '" + frame + "'";
    if (!isKnown(seen.frames, frame)) {
      findings.push_back({Verdict::kFault, here + ", which tf does not know",
                          isOdometry ? "in the drive's <plugin>: <frame_id>odom</frame_id>"
                                     : "in the <sensor>: <frame_id> with the name of its link",
                          isOdometry ? "Nav2, robot_localization" : "Nav2, slam_toolbox, robot_localization, RViz"});
    } else if (isKnown(seen.frames, odom) && rootOf(seen.frames, frame) != rootOf(seen.frames, odom)) {
      findings.push_back({Verdict::kHint, here + ", which is not connected to '" + odom + "'",
                          "for a sensor of the robot: a joint from its link to the robot's; for one in the world: "
                          "<ground_truth>always</ground_truth> of pongsim-ros2-system",
                          "Nav2, RViz"});
    }
  }
  for (const std::string& child : stream.childFrames) {
    if (isKnown(seen.frames, child)) continue;
    findings.push_back({Verdict::kFault, "'" + topic + "' is about frame '" + child + "', which tf does not know",
                        "in the drive's <plugin>: <child_frame_id> with the name of the robot's root link",
                        "Nav2, robot_localization"});
  }
}

void checkVariances(const std::string& topic, const StreamSeen& stream, Findings& findings) {
  if (!stream.lacksVariances) return;
  findings.push_back({Verdict::kHint, "'" + topic + "' has no covariances",
                      stream.type == kOdometry
                          ? "OdometryPublisher with <gaussian_noise>, and its topic odometry_with_covariance"
                          : "in the <sensor>: <noise type=\"gaussian\"><stddev>0.01</stddev></noise>",
                      "robot_localization"});
}

/// An image and its camera_info are siblings, and in one frame.
void checkCamera(const Observation& seen, const std::string& topic, Findings& findings) {
  const std::string info = topic.substr(0, topic.rfind('/')) + "/camera_info";
  const std::vector<std::string> infos = seen.topicsOf(kInfo);
  if (std::ranges::find(infos, info) == infos.end()) {
    findings.push_back({Verdict::kHint, "image '" + topic + "' has no '" + info + "' beside it",
                        "in the camera's <sensor>: <topic>camera/image_raw</topic>; or remap it in the node",
                        "RViz's Camera, image_proc"});
    return;
  }
  const auto image = seen.streams.find(topic), described = seen.streams.find(info);
  if (image == seen.streams.end() || described == seen.streams.end()) return;
  if (image->second.frames == described->second.frames) return;
  findings.push_back({Verdict::kFault,
                      "'" + topic + "' is in frame " + quoted(image->second.frames) + ", its camera_info in " +
                          quoted(described->second.frames),
                      "in the camera's <sensor>: <frame_id> with the name in <optical_frame_id>",
                      "RViz's Camera, image_proc"});
}

}  // namespace

Findings checkTopics(const Observation& seen, const Expected& expected) {
  Findings findings;
  for (const Wanted& each : kWanted) checkWanted(seen, each, absoluteName(expected.nameSpace, each.name), findings);
  std::set<std::string> topics;
  for (const char* type : {kScan, kOdometry, kImage, kInfo, kJoints, "sensor_msgs/msg/PointCloud2",
                           "sensor_msgs/msg/Imu", "sensor_msgs/msg/MagneticField", "sensor_msgs/msg/NavSatFix"}) {
    for (std::string& topic : seen.topicsOf(type)) topics.insert(std::move(topic));
  }
  for (const std::string& topic : topics) checkStream(seen, topic, findings);
  const std::size_t before = findings.size();
  for (const auto& [topic, stream] : seen.streams) {
    if (!seen.frames.empty()) checkFrame(seen, expected, topic, stream, findings);
  }
  if (findings.size() == before && !seen.streams.empty() && !seen.frames.empty()) {
    findings.push_back({Verdict::kGood, "tf knows the frames of all messages", {}, "all subscribers"});
  }
  for (const auto& [topic, stream] : seen.streams) checkVariances(topic, stream, findings);
  for (const std::string& topic : seen.topicsOf(kImage)) checkCamera(seen, topic, findings);
  return findings;
}

}  // namespace pongsim::ros2
