#pragma once

#include <ignition/msgs/any.pb.h>

#include "ros2/types/rcl_interfaces.hh"

namespace pongsim::ros2 {

/// A value that a parameter can't have (a colour, a pose) becomes unset.
void convert(const ignition::msgs::Any& from, rcl_interfaces::ParameterValue& to);
/// An integer that does not fit into 32 bits becomes the nearest that does; a list becomes unset, as in ros_gz.
void convert(const rcl_interfaces::ParameterValue& from, ignition::msgs::Any& to);

}  // namespace pongsim::ros2
