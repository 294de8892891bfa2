#pragma once

#include "ros2/config/topic_rule.hh"
#include "ros2/wire/qos.hh"

namespace pongsim::ros2 {

/// @param isLatched Whether the simulation keeps the topic's last message for who comes late.
/// @return The quality with which messages go to ROS: what the rule says, else what users expect of the topic.
Qos writerQos(const TopicRule& rule, bool isLatched);

/// @return The quality with which messages of ROS are read.
Qos readerQos(const TopicRule& rule);

/// @return Whether the simulation's topic is listened to only while a node of ROS listens: not where late nodes are to
/// get what was said before they came, unless the rule says so.
bool isLazyToRos(const TopicRule& rule, bool isLatched);

/// @return Whether the topic of ROS is read only while somebody listens in the simulation.
bool isLazyFromRos(const TopicRule& rule);

}  // namespace pongsim::ros2
