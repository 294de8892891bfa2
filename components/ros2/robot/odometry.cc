#include "ros2/robot/odometry.hh"

#include <algorithm>

#include "pongsim/element.hh"

namespace pongsim::ros2 {

std::vector<std::string> odometryTopics(const Model& model) {
  std::vector<std::string> names;
  bool hasPublisher = false;
  for (const Element* plugin : model.plugins()) {
    const Element* topic = plugin->child("tf_topic");
    if (topic != nullptr && !topic->text.empty()) {
      std::string name = cleanTopic(topic->text);
      if (!name.starts_with('/')) name.insert(0, "/");
      names.push_back(std::move(name));
    } else {
      hasPublisher |= plugin->attributeOr("filename", "").find("odometry-publisher") != std::string::npos;
    }
  }
  const std::string prefix = "/model/" + std::string(model.name());
  names.push_back(prefix + "/tf");
  // PosePublisher publishes the poses of all links on this topic, so it counts only with a system that publishes
  // odometry
  if (hasPublisher) names.push_back(prefix + "/pose");
  for (std::string& name : names) name = cleanTopic(name);
  return names;
}

std::string odometryTopic(const Model& model, const std::vector<OwnTopic>& topics) {
  for (const std::string& name : odometryTopics(model)) {
    const bool isThere = std::ranges::any_of(topics, [&name](const OwnTopic& topic) {
      return topic.name == name && topic.type == "ignition.msgs.Pose_V" && topic.publishers > 0;
    });
    if (isThere) return name;
  }
  return {};
}

}  // namespace pongsim::ros2
