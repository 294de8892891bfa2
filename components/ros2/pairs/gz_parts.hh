#pragma once

#include <ignition/msgs/contact.pb.h>
#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/joint_wrench.pb.h>
#include <ignition/msgs/light.pb.h>
#include <ignition/msgs/param.pb.h>
#include <ignition/msgs/track_visual.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <string>
#include <vector>

#include "ros2/pairs/frames.hh"
#include "ros2/types/ros_gz_interfaces.hh"

/// Conversions of the parts of ros_gz_interfaces' messages and services. Each overwrites all of `to`.
namespace pongsim::ros2 {

// Both number the types of entities alike.
void convert(const ignition::msgs::Entity& from, ros_gz_interfaces::Entity& to);
void convert(const ros_gz_interfaces::Entity& from, ignition::msgs::Entity& to);

void convert(const ignition::msgs::JointWrench& from, ros_gz_interfaces::JointWrench& to, const Frames& frames);
void convert(const ros_gz_interfaces::JointWrench& from, ignition::msgs::JointWrench& to, const Frames& frames);

void convert(const ignition::msgs::Contact& from, ros_gz_interfaces::Contact& to, const Frames& frames);
void convert(const ros_gz_interfaces::Contact& from, ignition::msgs::Contact& to, const Frames& frames);

void convert(const ignition::msgs::TrackVisual& from, ros_gz_interfaces::TrackVisual& to, const Frames& frames);
void convert(const ros_gz_interfaces::TrackVisual& from, ignition::msgs::TrackVisual& to, const Frames& frames);

void convert(const ignition::msgs::Light& from, ros_gz_interfaces::Light& to, const Frames& frames);
void convert(const ros_gz_interfaces::Light& from, ignition::msgs::Light& to, const Frames& frames);

/// A reset and a time to run to are set only if requested.
void convert(const ignition::msgs::WorldControl& from, ros_gz_interfaces::WorldControl& to);
void convert(const ros_gz_interfaces::WorldControl& from, ignition::msgs::WorldControl& to);

/// Adds the parameters sorted by name, then those of the children, "child_0/NAME".
/// @param prefix Of each name.
void addParameters(const ignition::msgs::Param& from, const std::string& prefix,
                   std::vector<rcl_interfaces::Parameter>& to);
void convert(const ros_gz_interfaces::ParamVec& from, ignition::msgs::Param& to, const Frames& frames);

/// For lists whose elements convert to each other.
template <class From, class To>
void convertList(const From& from, std::vector<To>& to, const Frames& frames) {
  to.resize(static_cast<std::size_t>(from.size()));
  for (int i = 0; i < from.size(); ++i) convert(from.Get(i), to[static_cast<std::size_t>(i)], frames);
}

}  // namespace pongsim::ros2
