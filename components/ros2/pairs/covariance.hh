#pragma once

#include <ignition/msgs/pose_with_covariance.pb.h>
#include <ignition/msgs/twist_with_covariance.pb.h>

#include "ros2/types/geometry_msgs.hh"

namespace pongsim::ros2 {

// The 36 numbers of a covariance matrix are row by row of (x, y, z, about x, y, z) on both sides; a message with
// another number of them has none, which ROS represents by zeros.

void convert(const ignition::msgs::PoseWithCovariance& from, geometry_msgs::PoseWithCovariance& to);
void convert(const geometry_msgs::PoseWithCovariance& from, ignition::msgs::PoseWithCovariance& to);
void convert(const ignition::msgs::TwistWithCovariance& from, geometry_msgs::TwistWithCovariance& to);
void convert(const geometry_msgs::TwistWithCovariance& from, ignition::msgs::TwistWithCovariance& to);

}  // namespace pongsim::ros2
