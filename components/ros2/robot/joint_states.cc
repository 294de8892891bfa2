#include "ros2/robot/joint_states.hh"

#include <algorithm>

#include "ros2/robot/joint_effort.hh"

namespace pongsim::ros2 {

void JointStates::add(const std::string& name, const std::vector<RobotJoints>& robots) {
  JointTopic& topic = topics_.emplace_back();
  topic.name = ros_.resolve(name);
  for (const RobotJoints& each : robots) {
    for (const TreeLink& link : each.robot->tree.links) {
      if (!link.source) continue;
      topic.axes.emplace_back(*link.source, link.sourceAxis);
      topic.message.name.push_back(each.prefix + link.joint);
    }
  }
  const std::size_t count = topic.axes.size();
  topic.message.position.resize(count);
  topic.message.velocity.resize(count);
  topic.message.effort.resize(count);
  topic.publisher = ros_.advertise<sensor_msgs::JointState>(name);
}

std::vector<std::string> JointStates::topics() const {
  std::vector<std::string> names;
  for (const JointTopic& topic : topics_) names.push_back(topic.name);
  return names;
}

void JointStates::postUpdate(Time now) {
  const bool isRead =
      std::ranges::any_of(topics_, [](const JointTopic& topic) { return topic.publisher->hasReaders(); });
  if (!isRead || !schedule_.isDue(now)) return;
  const builtin_interfaces::Time stamp = stampOf(now, frames_);
  for (JointTopic& topic : topics_) {
    if (topic.publisher->hasReaders()) publish(topic, stamp);
  }
}

void JointStates::publish(JointTopic& topic, const builtin_interfaces::Time& stamp) const {
  topic.message.header.stamp = stamp;
  for (std::size_t i = 0; i < topic.axes.size(); ++i) {
    const auto& [joint, axis] = topic.axes[i];
    topic.message.position[i] = joint.position(axis);
    topic.message.velocity[i] = joint.velocity(axis);
    topic.message.effort[i] = jointEffort(joint, axis);
  }
  topic.publisher->publish(topic.message);
}

}  // namespace pongsim::ros2
