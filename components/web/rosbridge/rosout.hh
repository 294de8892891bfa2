#pragma once

#include <string>
#include <string_view>

#include "web/rosbridge/definition.hh"
#include "web/world/recent_log.hh"

/// The topic /rosout, which each client of rosbridge finds: the program rosbridge_server publishes it, and Foxglove
/// tells ROS 2 from ROS 1 by its type.
namespace pongsim::web::rosbridge {

inline constexpr std::string_view kRosout = "/rosout";
inline constexpr std::string_view kRosoutType = "rcl_interfaces/msg/Log";
extern const std::string_view kRosoutSchema;

const RosDefinition& rosoutDefinition();

/// @return The message in CDR.
std::string rosoutMessage(const RecentLog::Line& line);

}  // namespace pongsim::web::rosbridge
