#include "ros2/robot/rival_publishers.hh"

#include <utility>

namespace pongsim::ros2 {

namespace {
constexpr Qos kStaticReaderQos{.isTransientLocal = true, .depth = 100};
constexpr Qos kMovingReaderQos{.isReliable = false, .depth = 100};
// What others can make us keep: frames beyond that are not checked.
constexpr std::size_t kMostFrames = 10'000;
}  // namespace

void RivalPublishers::watchTransforms() {
  const auto received = [this](const tf2_msgs::TFMessage& message) { receive(message); };
  moving_ = ros_.subscribe<tf2_msgs::TFMessage>("/tf", received, kMovingReaderQos);
  static_ = ros_.subscribe<tf2_msgs::TFMessage>("/tf_static", received, kStaticReaderQos);
}

/// Called from a DDS thread.
void RivalPublishers::receive(const tf2_msgs::TFMessage& message) {
  const std::lock_guard lock(mutex_);
  for (const geometry_msgs::TransformStamped& each : message.transforms) {
    if (known_.size() >= kMostFrames || !known_.insert(each.child_frame_id).second) continue;
    heard_.emplace_back(each.child_frame_id, each.header.frame_id);
  }
}

void RivalPublishers::checkTransforms(const std::set<std::string>& children) {
  std::vector<std::pair<std::string, std::string>> rivals;
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(heard_, [&](const auto& each) {
      // frames may get a parent here later
      if (!children.contains(each.first)) return false;
      rivals.push_back(each);
      return true;
    });
  }
  for (const auto& [child, parent] : rivals) {
    ros_.log().warning("another node publishes the frame '" + child + "' in '" + parent +
                       "', which the simulation publishes, too: --ros2-no-link-tf leaves robots' links to it, "
                       "--ros2-no-tf all frames");
  }
}

void RivalPublishers::checkTopic(const std::string& topic, const std::string& option, const std::string& meaning) {
  if (warned_.contains(topic)) return;
  for (const Graph::Endpoint& each : ros_.participant().graph().endpointsOn(topicOnWire(topic), Graph::Role::kWriter)) {
    if (each.id.isOfSameParticipant(ros_.participant().id())) continue;
    warned_.insert(topic);
    ros_.log().warning("another node publishes '" + topic + "', too: " + meaning + "; " + option + " leaves it to it");
    return;
  }
}

}  // namespace pongsim::ros2
