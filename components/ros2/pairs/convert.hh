#pragma once

#include <ignition/msgs/color.pb.h>
#include <ignition/msgs/double_v.pb.h>
#include <ignition/msgs/float_v.pb.h>
#include <ignition/msgs/header.pb.h>
#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/quaternion.pb.h>
#include <ignition/msgs/time.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <ignition/msgs/vector3d.pb.h>
#include <ignition/msgs/wrench.pb.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "ros2/pairs/frames.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

/// Conversions of the parts of messages. Each overwrites all of `to`.
namespace pongsim::ros2 {

void convert(const ignition::msgs::Time& from, builtin_interfaces::Time& to);
void convert(const builtin_interfaces::Time& from, ignition::msgs::Time& to);

/// The stamp, and `frame_id` from the header's data.
void convert(const ignition::msgs::Header& from, std_msgs::Header& to, const Frames& frames);
void convert(const std_msgs::Header& from, ignition::msgs::Header& to, const Frames& frames);

/// `child_frame_id` from the header's data; empty if there is none.
void childFrame(const ignition::msgs::Header& from, std::string& to, const Frames& frames);
/// Adds it to the header.
void addChildFrame(const std::string& from, ignition::msgs::Header& to, const Frames& frames);

void convert(const ignition::msgs::Vector3d& from, geometry_msgs::Vector3& to);
void convert(const geometry_msgs::Vector3& from, ignition::msgs::Vector3d& to);
void convert(const ignition::msgs::Vector3d& from, geometry_msgs::Point& to);
void convert(const geometry_msgs::Point& from, ignition::msgs::Vector3d& to);
/// An unset quaternion (all zeros) becomes the identity.
void convert(const ignition::msgs::Quaternion& from, geometry_msgs::Quaternion& to);
void convert(const geometry_msgs::Quaternion& from, ignition::msgs::Quaternion& to);

// Only position and orientation of a pose.
void convert(const ignition::msgs::Pose& from, geometry_msgs::Pose& to);
void convert(const geometry_msgs::Pose& from, ignition::msgs::Pose& to);
void convert(const ignition::msgs::Pose& from, geometry_msgs::Transform& to);
void convert(const geometry_msgs::Transform& from, ignition::msgs::Pose& to);
/// With header and child frame.
void convert(const ignition::msgs::Pose& from, geometry_msgs::TransformStamped& to, const Frames& frames);
void convert(const geometry_msgs::TransformStamped& from, ignition::msgs::Pose& to, const Frames& frames);

// Without the header.
void convert(const ignition::msgs::Twist& from, geometry_msgs::Twist& to);
void convert(const geometry_msgs::Twist& from, ignition::msgs::Twist& to);
void convert(const ignition::msgs::Wrench& from, geometry_msgs::Wrench& to);
void convert(const geometry_msgs::Wrench& from, ignition::msgs::Wrench& to);

void convert(const ignition::msgs::Color& from, std_msgs::ColorRGBA& to);
void convert(const std_msgs::ColorRGBA& from, ignition::msgs::Color& to);

/// Copies a list of numbers to one of another type or kind.
template <class From, class To>
void copyNumbers(const From& from, To& to) {
  to.clear();
  to.reserve(static_cast<std::size_t>(from.size()));
  for (const auto value : from) to.push_back(static_cast<typename To::value_type>(value));
}

/// Appends numbers to a list in a message.
template <class From, class To>
void addNumbers(const From& from, To* to) {
  to->Reserve(to->size() + static_cast<int>(from.size()));
  for (const auto value : from) to->Add(value);
}

/// Fills an array if the message has as many numbers, else with zeros.
template <class From, class To>
void copyToArray(const From& from, To& to) {
  if (static_cast<std::size_t>(from.size()) == to.size()) {
    std::copy(from.begin(), from.end(), to.begin());
  } else {
    to.fill(0);
  }
}

}  // namespace pongsim::ros2
