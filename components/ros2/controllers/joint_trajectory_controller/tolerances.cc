#include "ros2/controllers/joint_trajectory_controller/tolerances.hh"

#include <algorithm>
#include <cmath>

namespace pongsim::ros2 {

namespace {

/// @return False for a value that is none.
bool takeTolerance(double given, double& tolerance) {
  constexpr double kErase = -1;
  if (given > 0 && std::isfinite(given)) {
    tolerance = given;
  } else if (given == kErase) {
    tolerance = 0;
  } else if (given != 0) {
    return false;
  }
  return true;
}

/// @return Why one of them can't be taken; empty: all are.
std::string takeTolerances(const std::vector<control_msgs::JointTolerance>& given,
                           const std::vector<std::string>& joints, std::vector<StateTolerance>& tolerances) {
  for (const control_msgs::JointTolerance& each : given) {
    const auto joint = std::ranges::find(joints, each.name);
    if (joint == joints.end()) return "it has a tolerance of joint '" + each.name + "', which is not one of its joints";
    StateTolerance& tolerance = tolerances[static_cast<std::size_t>(joint - joints.begin())];
    if (!takeTolerance(each.position, tolerance.position) || !takeTolerance(each.velocity, tolerance.velocity) ||
        !takeTolerance(each.acceleration, tolerance.acceleration)) {
      return "a tolerance of joint '" + each.name + "' is below zero, and not -1";
    }
  }
  return {};
}

}  // namespace

bool StateTolerance::contains(const TrajectoryPoint& errors, std::size_t joint) const {
  const auto isWithin = [joint](double tolerance, const std::vector<double>& values) {
    return !(tolerance > 0) || values.empty() || std::abs(values[joint]) <= tolerance;
  };
  return isWithin(position, errors.positions) && isWithin(velocity, errors.velocities) &&
         isWithin(acceleration, errors.accelerations);
}

void StateTolerance::transfer(StateArchive& archive) {
  archive(position);
  archive(velocity);
  archive(acceleration);
}

TrajectoryTolerances TrajectoryTolerances::read(ControllerParameters& parameters,
                                                const std::vector<std::string>& joints) {
  TrajectoryTolerances tolerances;
  tolerances.goalTime = parameters.number("constraints.goal_time", 0);
  const double stopped = parameters.number("constraints.stopped_velocity_tolerance", 0.01);
  for (const std::string& joint : joints) {
    const std::string prefix = "constraints." + joint;
    tolerances.path.push_back({parameters.number(prefix + ".trajectory", 0), 0, 0});
    tolerances.goal.push_back({parameters.number(prefix + ".goal", 0), stopped, 0});
  }
  return tolerances;
}

Outcome<TrajectoryTolerances> TrajectoryTolerances::withThoseOf(
    const control_msgs::action::FollowJointTrajectory::Goal& request, const std::vector<std::string>& joints) const {
  TrajectoryTolerances tolerances = *this;
  const builtin_interfaces::Duration& time = request.goal_time_tolerance;
  if (!takeTolerance(time.sec + time.nanosec * 1e-9, tolerances.goalTime))
    return {{}, "its time tolerance is below zero"};
  std::string why = takeTolerances(request.path_tolerance, joints, tolerances.path);
  if (why.empty()) why = takeTolerances(request.goal_tolerance, joints, tolerances.goal);
  if (!why.empty()) return {{}, why};
  return {tolerances, {}};
}

void TrajectoryTolerances::transfer(StateArchive& archive, std::size_t joints) {
  archive(path);
  archive(goal);
  archive(goalTime);
  archive.check(path.size() == joints && goal.size() == joints);
}

}  // namespace pongsim::ros2
