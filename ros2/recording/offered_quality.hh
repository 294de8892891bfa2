#pragma once

#include <string>

#include "ros2/wire/qos.hh"

namespace pongsim::ros2 {

/// @return A quality of service as bags have it with a topic ("offered_qos_profiles"): a list of one in YAML, with the
/// numbers of rmw, which all distributions read; the names that came with Jazzy older ones do not.
std::string offeredQuality(const Qos& qos);

}  // namespace pongsim::ros2
