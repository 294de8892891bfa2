#include "trajectory.hh"

#include <chrono>

namespace pongsim {

namespace {

using PointMessage = ignition::msgs::JointTrajectoryPoint;

Time timeOf(const PointMessage& point) {
  return std::chrono::seconds(point.time_from_start().sec()) + std::chrono::nanoseconds(point.time_from_start().nsec());
}

/// @return What is wrong with a point, or nothing.
std::optional<std::string> faultOf(const PointMessage& point, int joints) {
  const auto fits = [joints](int count) { return count == 0 || count == joints; };
  if (!fits(point.positions_size()) || !fits(point.velocities_size()) || !fits(point.effort_size())) {
    return "does not have a value for each of the " + std::to_string(joints) + " joints";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> Trajectory::fault(const ignition::msgs::JointTrajectory& message) {
  if (message.joint_names_size() == 0) return "it has no joint names";
  if (message.points_size() == 0) return "it has no points";
  Time last{-1};
  for (int i = 0; i < message.points_size(); ++i) {
    const std::string name = "point " + std::to_string(i);
    if (const auto found = faultOf(message.points(i), message.joint_names_size())) return name + " " + *found;
    const Time time = timeOf(message.points(i));
    if (time <= last) return name + " is not later than the previous one";
    last = time;
  }
  return std::nullopt;
}

Trajectory::Trajectory(const ignition::msgs::JointTrajectory& message, Time start)
    : joints_(message.joint_names().begin(), message.joint_names().end()), start_(start) {
  for (const PointMessage& point : message.points()) {
    points_.push_back({timeOf(point),
                       {point.positions().begin(), point.positions().end()},
                       {point.velocities().begin(), point.velocities().end()},
                       {point.effort().begin(), point.effort().end()}});
  }
}

bool Trajectory::advance(Time now) {
  if (now < start_) return false;
  const std::size_t before = current_;
  while (current_ + 1 < points_.size() && points_[current_].time < now - start_) ++current_;
  const bool isNew = !started_ || current_ != before;
  started_ = true;
  return isNew;
}

void Trajectory::target(std::size_t joint, JointTarget& target) const {
  const Point& point = points_[current_];
  if (joint < point.positions.size()) target.position = point.positions[joint];
  if (joint < point.velocities.size()) target.velocity = point.velocities[joint];
  if (joint < point.efforts.size()) target.effort = point.efforts[joint];
}

void Trajectory::transfer(StateArchive& archive) {
  archive(joints_);
  archive(points_);
  archive(start_);
  archive(current_);
  archive(started_);
  archive.check(current_ < points_.size());
}

double Trajectory::progress() const { return static_cast<double>(current_ + 1) / static_cast<double>(points_.size()); }

}  // namespace pongsim
