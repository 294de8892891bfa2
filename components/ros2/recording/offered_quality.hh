#pragma once

#include <string>

#include "ros2/wire/qos.hh"

namespace pongsim::ros2 {

/// @return A quality of service in the form that bags store with a topic ("offered_qos_profiles"): a YAML list of one,
/// with rmw's numbers, which all distributions can read; older ones can't read the names introduced in Jazzy.
std::string offeredQuality(const Qos& qos);

}  // namespace pongsim::ros2
