#pragma once

#include <string>

#include "pongsim/export.hh"

namespace pongsim {

/// An environment variable of Gazebo, under both of its names.
struct GazeboVariable {
  /// In Fortress, which comes first where both are set.
  const char* fortress;
  /// Since Garden.
  const char* later;

  /// @return Its value under the first name under which it is set and not empty; otherwise empty.
  PONGSIM_API std::string value() const;
};

/// The variables that pongsim reads, or warns about.
namespace gazebo {

inline constexpr GazeboVariable kResourcePath{"IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH"};
inline constexpr GazeboVariable kFilePath{"IGN_FILE_PATH", "GZ_FILE_PATH"};
inline constexpr GazeboVariable kSystemPluginPath{"IGN_GAZEBO_SYSTEM_PLUGIN_PATH", "GZ_SIM_SYSTEM_PLUGIN_PATH"};
inline constexpr GazeboVariable kServerConfigPath{"IGN_GAZEBO_SERVER_CONFIG_PATH", "GZ_SIM_SERVER_CONFIG_PATH"};
inline constexpr GazeboVariable kPhysicsEnginePath{"IGN_GAZEBO_PHYSICS_ENGINE_PATH", "GZ_SIM_PHYSICS_ENGINE_PATH"};
inline constexpr GazeboVariable kFuelCachePath{"IGN_FUEL_CACHE_PATH", "GZ_FUEL_CACHE_PATH"};

inline constexpr GazeboVariable kPartition{"IGN_PARTITION", "GZ_PARTITION"};
inline constexpr GazeboVariable kIp{"IGN_IP", "GZ_IP"};
inline constexpr GazeboVariable kRelay{"IGN_RELAY", "GZ_RELAY"};
inline constexpr GazeboVariable kMulticastIp{"IGN_DISCOVERY_MULTICAST_IP", "GZ_DISCOVERY_MULTICAST_IP"};
inline constexpr GazeboVariable kMessagePort{"IGN_DISCOVERY_MSG_PORT", "GZ_DISCOVERY_MSG_PORT"};
inline constexpr GazeboVariable kServicePort{"IGN_DISCOVERY_SRV_PORT", "GZ_DISCOVERY_SRV_PORT"};
inline constexpr GazeboVariable kUsername{"IGN_TRANSPORT_USERNAME", "GZ_TRANSPORT_USERNAME"};
inline constexpr GazeboVariable kPassword{"IGN_TRANSPORT_PASSWORD", "GZ_TRANSPORT_PASSWORD"};
inline constexpr GazeboVariable kStatistics{"IGN_TRANSPORT_TOPIC_STATISTICS", "GZ_TRANSPORT_TOPIC_STATISTICS"};
inline constexpr GazeboVariable kSendQueue{"IGN_TRANSPORT_SNDHWM", "GZ_TRANSPORT_SNDHWM"};
inline constexpr GazeboVariable kReceiveQueue{"IGN_TRANSPORT_RCVHWM", "GZ_TRANSPORT_RCVHWM"};
inline constexpr GazeboVariable kVerbose{"IGN_VERBOSE", "GZ_VERBOSE"};

}  // namespace gazebo

}  // namespace pongsim
