#pragma once

#include "ros2/config/topic_rule.hh"
#include "ros2/wire/qos.hh"

namespace pongsim::ros2 {

/// @param isLatched Whether the simulation keeps the topic's last message for late subscribers.
/// @return The quality of service for messages to ROS: from the rule, else what users expect of the topic.
Qos writerQos(const TopicRule& rule, bool isLatched);

/// @return The quality of service for messages from ROS.
Qos readerQos(const TopicRule& rule);

/// @return Whether the simulation's topic is subscribed to only while a ROS node subscribes: unless the rule sets it,
/// false for topics where late nodes should get earlier messages.
bool isLazyToRos(const TopicRule& rule, bool isLatched);

/// @return Whether the ROS topic is read only while somebody in the simulation subscribes.
bool isLazyFromRos(const TopicRule& rule);

}  // namespace pongsim::ros2
