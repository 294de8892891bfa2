#include "ros2/robot/joint_states.hh"

#include <algorithm>

#include "ros2/robot/joint_effort.hh"

namespace pongsim::ros2 {

void JointStates::add(const std::string& topic, const std::vector<Part>& parts) {
  Told& told = told_.emplace_back();
  for (const Part& part : parts) {
    for (const TreeLink& link : part.robot->tree.links) {
      if (!link.source) continue;
      told.axes.emplace_back(*link.source, link.sourceAxis);
      told.message.name.push_back(part.prefix + link.joint);
    }
  }
  const std::size_t count = told.axes.size();
  told.message.position.resize(count);
  told.message.velocity.resize(count);
  told.message.effort.resize(count);
  told.publisher = ros_.advertise<sensor_msgs::JointState>(topic);
}

void JointStates::postUpdate(Time now) {
  const bool isRead = std::ranges::any_of(told_, [](const Told& told) { return told.publisher->hasReaders(); });
  if (!isRead || !schedule_.isDue(now)) return;
  const builtin_interfaces::Time stamp = stampOf(now, frames_);
  for (Told& told : told_) {
    if (told.publisher->hasReaders()) tell(told, stamp);
  }
}

void JointStates::tell(Told& told, const builtin_interfaces::Time& stamp) const {
  told.message.header.stamp = stamp;
  for (std::size_t i = 0; i < told.axes.size(); ++i) {
    const auto& [joint, axis] = told.axes[i];
    told.message.position[i] = joint.position(axis);
    told.message.velocity[i] = joint.velocity(axis);
    told.message.effort[i] = jointEffort(joint, axis);
  }
  told.publisher->publish(told.message);
}

}  // namespace pongsim::ros2
