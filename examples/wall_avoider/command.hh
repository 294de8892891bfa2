#pragma once

#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <algorithm>

namespace wall_avoider {

inline constexpr double kNear = 1.0;   // [m]
inline constexpr double kAhead = 0.5;  // [m/s]
inline constexpr double kTurn = 0.5;   // [rad/s]

/// What to do where one sees that.
inline ignition::msgs::Twist commandFor(const ignition::msgs::LaserScan& scan) {
  const bool isFree = std::none_of(scan.ranges().begin(), scan.ranges().end(), [](double r) { return r < kNear; });
  ignition::msgs::Twist command;
  command.mutable_linear()->set_x(isFree ? kAhead : 0);
  command.mutable_angular()->set_z(isFree ? 0 : kTurn);
  return command;
}

}  // namespace wall_avoider
