#include "ros2/controllers/joint_trajectory_controller/trajectory_message.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pongsim/commands.hh"
#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {

bool isSoundList(const std::vector<double>& list) {
  return std::ranges::all_of(list, [](double value) { return std::abs(value) <= kLargestForce; });
}

std::string wrongWithPoint(const trajectory_msgs::JointTrajectoryPoint& point, const TrajectoryRules& rules,
                           std::size_t joints) {
  if (point.positions.empty() &&
      !(rules.allowsIntegration && (!point.velocities.empty() || !point.accelerations.empty()))) {
    return "no positions";
  }
  for (const auto* list : {&point.positions, &point.velocities, &point.accelerations, &point.effort}) {
    if (!list->empty() && list->size() != joints) {
      return std::to_string(list->size()) + " values for " + std::to_string(joints) + " joints";
    }
    if (!isSoundList(*list)) return "a value that is not finite, or very large";
  }
  if (!point.effort.empty() && !rules.takesEffort) return "efforts, without a command interface for them";
  return {};
}

/// Why a trajectory is refused; empty: it is not.
std::string wrongWith(const trajectory_msgs::JointTrajectory& message, const TrajectoryRules& rules, Time now) {
  if (message.points.empty()) return "it has no points";
  if (message.joint_names.empty()) return "it has no joints";
  if (message.joint_names.size() != rules.joints.size() && !rules.allowsPartial) {
    return "it has " + std::to_string(message.joint_names.size()) + " of the " + std::to_string(rules.joints.size()) +
           " joints; 'allow_partial_joints_goal' would allow that";
  }
  for (std::size_t i = 0; i < message.joint_names.size(); ++i) {
    const std::string& name = message.joint_names[i];
    if (std::ranges::find(rules.joints, name) == rules.joints.end())
      return "joint '" + name + "' is none of its joints";
    if (std::find(message.joint_names.begin(), message.joint_names.begin() + static_cast<std::ptrdiff_t>(i), name) !=
        message.joint_names.begin() + static_cast<std::ptrdiff_t>(i)) {
      return "joint '" + name + "' is there twice";
    }
  }
  for (std::size_t i = 0; i < message.points.size(); ++i) {
    const std::string why = wrongWithPoint(message.points[i], rules, message.joint_names.size());
    if (!why.empty()) return "point " + std::to_string(i) + " has " + why;
    if (i > 0 && timeOf(message.points[i].time_from_start) <= timeOf(message.points[i - 1].time_from_start)) {
      return "the time of point " + std::to_string(i) + " is not after that of the one before";
    }
  }
  const auto& last = message.points.back();
  const bool stops = std::ranges::all_of(
      last.velocities, [](double each) { return std::abs(each) <= std::numeric_limits<float>::epsilon(); });
  if (!stops && !rules.allowsVelocityAtEnd) {
    return "it does not end at rest; 'allow_nonzero_velocity_at_trajectory_end' would allow that";
  }
  const Time start = timeOf(message.header.stamp);
  if (start != Time::zero() && start + timeOf(last.time_from_start) < now) return "it ends in the past";
  return {};
}

}  // namespace

Outcome<Trajectory> readTrajectory(const trajectory_msgs::JointTrajectory& message, const TrajectoryRules& rules,
                                   const std::vector<double>& held, Time now) {
  const std::string wrong = wrongWith(message, rules, now);
  if (!wrong.empty()) return {{}, wrong};
  std::vector<std::size_t> places;
  for (const std::string& name : message.joint_names) {
    places.push_back(static_cast<std::size_t>(std::ranges::find(rules.joints, name) - rules.joints.begin()));
  }
  // joints that are left out are held
  const auto sorted = [&](const std::vector<double>& list, const std::vector<double>& others) {
    if (list.empty()) return std::vector<double>();
    std::vector<double> all = others;
    for (std::size_t i = 0; i < list.size(); ++i) all[places[i]] = list[i];
    return all;
  };
  const std::vector<double> zeros(rules.joints.size(), 0.0);
  std::vector<TrajectoryPoint> points;
  for (const auto& each : message.points) {
    points.push_back({timeOf(each.time_from_start), sorted(each.positions, held), sorted(each.velocities, zeros),
                      sorted(each.accelerations, zeros), sorted(each.effort, zeros)});
  }
  return {Trajectory(timeOf(message.header.stamp), std::move(points)), {}};
}

}  // namespace pongsim::ros2
