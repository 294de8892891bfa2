#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::msgs {

/// @param name Name of a component of Fortress, such as "Pose".
/// @return Its type id in states: a hash of its full name (FNV-1a, 64 bits).
std::uint64_t componentType(std::string_view name);

/// Numeric components are stored as text.
std::string componentText(double value);
/// Several numbers are separated by spaces; a pose is x y z roll pitch yaw [m, rad].
std::string componentText(const Vector3& vector);
std::string componentText(const Pose& pose);

/// @return The vector or pose, if the text is valid.
std::optional<Vector3> vectorOfComponent(std::string_view text);
std::optional<Pose> poseOfComponent(std::string_view text);

/// @return Fortress's component for sensors of a type, such as "Imu" for "imu"; empty if there is none that holds a
/// message.
std::string_view sensorComponent(std::string_view type);
/// @return All of these.
std::vector<std::string_view> sensorComponents();

/// @return The number of a joint type in Fortress's states: 6 for "revolute"; 0 if there is none.
int jointTypeNumber(std::string_view type);
/// @return The reverse; empty for unknown numbers.
std::string_view jointTypeOfNumber(int number);

}  // namespace pongsim::msgs
