#pragma once

#include <ignition/msgs/header.pb.h>
#include <ignition/msgs/time.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include "ros2/pairs/frames.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

/// Parts of messages, for the pairs that have them.
namespace pongsim::ros2 {

void convert(const ignition::msgs::Time& from, builtin_interfaces::Time& to);
void convert(const builtin_interfaces::Time& from, ignition::msgs::Time& to);

/// The stamp, and `frame_id` of its data.
void convert(const ignition::msgs::Header& from, std_msgs::Header& to, const Frames& frames);
void convert(const std_msgs::Header& from, ignition::msgs::Header& to, const Frames& frames);

void convert(const ignition::msgs::Vector3d& from, geometry_msgs::Vector3& to);
void convert(const geometry_msgs::Vector3& from, ignition::msgs::Vector3d& to);

}  // namespace pongsim::ros2
