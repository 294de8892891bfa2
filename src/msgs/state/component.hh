#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::msgs {

/// @param name Of a component of Fortress, as "Pose".
/// @return The number that stands for it in states: a hash of its full name (FNV-1a, 64 bits).
std::uint64_t componentType(std::string_view name);

/// Components that are numbers are text.
std::string componentText(double value);
/// Components that are several numbers are text with blanks between them; a pose is x y z roll pitch yaw [m, rad].
std::string componentText(const Vector3& vector);
std::string componentText(const Pose& pose);

/// @return The vector or the pose, where the text is one.
std::optional<Vector3> vectorOfComponent(std::string_view text);
std::optional<Pose> poseOfComponent(std::string_view text);

/// @return The component of Fortress that tells of sensors of that type, as "Imu" of "imu"; empty where there is none
/// that is a message.
std::string_view sensorComponent(std::string_view type);
/// @return All of these.
std::vector<std::string_view> sensorComponents();

/// @return The number with which Fortress's states name a type of joint: 6 for "revolute"; 0 where there is none.
int jointTypeNumber(std::string_view type);
/// @return The reverse; empty for a number that is none.
std::string_view jointTypeOfNumber(int number);

}  // namespace pongsim::msgs
