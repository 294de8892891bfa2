#include "ros2/controllers/joint_trajectory_controller/trajectory.hh"

#include <algorithm>

namespace pongsim::ros2 {

namespace {

/// Where positions are not given, they follow from the means of the derivatives in the time between.
void deduce(TrajectoryPoint& first, TrajectoryPoint& second, double dt) {
  const std::size_t count = first.positions.size();
  if (!second.positions.empty()) return;
  if (first.velocities.empty()) first.velocities.assign(count, 0);
  if (second.velocities.empty()) {
    if (first.accelerations.empty()) first.accelerations.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      second.velocities.push_back(first.velocities[i] + (first.accelerations[i] + second.accelerations[i]) / 2 * dt);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    second.positions.push_back(first.positions[i] + (first.velocities[i] + second.velocities[i]) / 2 * dt);
  }
}

/// Polynomial c0 + c1 t + ... + c5 t^5 of one joint between two points.
struct Spline {
  double c[6] = {};

  double position(double t) const { return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5])))); }
  double velocity(double t) const { return c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * 5 * c[5]))); }
  double acceleration(double t) const { return 2 * c[2] + t * (6 * c[3] + t * (12 * c[4] + t * 20 * c[5])); }
};

/// @param T Time between the points [s].
Spline splineBetween(const TrajectoryPoint& a, const TrajectoryPoint& b, std::size_t joint, double T) {
  const double p0 = a.positions[joint], p1 = b.positions[joint];
  const bool hasVelocities = !a.velocities.empty() && !b.velocities.empty();
  const bool hasAccelerations = hasVelocities && !a.accelerations.empty() && !b.accelerations.empty();
  Spline spline;
  spline.c[0] = p0;
  if (T <= 0) return spline;
  if (!hasVelocities) {
    spline.c[1] = (p1 - p0) / T;
    return spline;
  }
  const double v0 = a.velocities[joint], v1 = b.velocities[joint];
  spline.c[1] = v0;
  if (!hasAccelerations) {
    // that of Hermite
    spline.c[2] = (3 * (p1 - p0) - (2 * v0 + v1) * T) / (T * T);
    spline.c[3] = (2 * (p0 - p1) + (v0 + v1) * T) / (T * T * T);
    return spline;
  }
  const double a0 = a.accelerations[joint], a1 = b.accelerations[joint];
  spline.c[2] = a0 / 2;
  spline.c[3] = (20 * (p1 - p0) - (8 * v1 + 12 * v0) * T - (3 * a0 - a1) * T * T) / (2 * T * T * T);
  spline.c[4] = (30 * (p0 - p1) + (14 * v1 + 16 * v0) * T + (3 * a0 - 2 * a1) * T * T) / (2 * T * T * T * T);
  spline.c[5] = (12 * (p1 - p0) - 6 * (v1 + v0) * T + (a1 - a0) * T * T) / (2 * T * T * T * T * T);
  return spline;
}

/// @param t Time since the first of them [s].
TrajectoryPoint between(const TrajectoryPoint& a, const TrajectoryPoint& b, double t, double T) {
  TrajectoryPoint state;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    const Spline spline = splineBetween(a, b, i, T);
    state.positions.push_back(spline.position(t));
    state.velocities.push_back(spline.velocity(t));
    state.accelerations.push_back(spline.acceleration(t));
    const double e0 = a.effort.empty() ? 0 : a.effort[i], e1 = b.effort.empty() ? 0 : b.effort[i];
    state.effort.push_back(T > 0 ? e0 + (e1 - e0) * t / T : e0);
  }
  return state;
}

/// What is not given is zero.
TrajectoryPoint completed(TrajectoryPoint point) {
  for (auto* list : {&point.velocities, &point.accelerations, &point.effort}) {
    if (list->empty()) list->assign(point.positions.size(), 0);
  }
  return point;
}

}  // namespace

void TrajectoryPoint::transfer(StateArchive& archive) {
  archive(time);
  for (auto* list : {&positions, &velocities, &accelerations, &effort}) archive(*list);
}

void Trajectory::begin(Time now, TrajectoryPoint before) {
  hasBegun_ = true;
  if (start_ == Time::zero()) start_ = now;
  begun_ = now;
  before_ = std::move(before);
  const std::size_t count = before_.positions.size();
  // otherwise the way to the first point would be of another degree than the rest
  if (before_.velocities.empty() && !points_[0].velocities.empty()) before_.velocities.assign(count, 0);
  if (before_.accelerations.empty() && !points_[0].accelerations.empty()) before_.accelerations.assign(count, 0);
  deduce(before_, points_[0], toSeconds(timeOf(0) - begun_));
  for (std::size_t i = 1; i < points_.size(); ++i) {
    deduce(points_[i - 1], points_[i], toSeconds(points_[i].time - points_[i - 1].time));
  }
}

Trajectory::Sample Trajectory::sample(Time now, bool interpolates) const {
  if (now < timeOf(0)) {
    if (!interpolates) return {completed(before_), 0, false};
    const Time since = std::max(now - begun_, Time::zero());
    return {between(before_, points_[0], toSeconds(since), toSeconds(timeOf(0) - begun_)), 0, false};
  }
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    if (now >= timeOf(i + 1)) continue;
    if (!interpolates) return {completed(points_[i + 1]), i, false};
    const double T = toSeconds(points_[i + 1].time - points_[i].time);
    return {between(points_[i], points_[i + 1], toSeconds(now - timeOf(i)), T), i, false};
  }
  return {completed(points_.back()), points_.size() - 1, true};
}

void Trajectory::transfer(StateArchive& archive, std::size_t joints) {
  archive(hasBegun_);
  archive(start_);
  archive(begun_);
  archive(before_);
  archive(points_);
  archive.check(!points_.empty() && (!hasBegun_ || before_.positions.size() == joints));
  for (const TrajectoryPoint& point : points_) {
    for (const auto* list : {&point.positions, &point.velocities, &point.accelerations, &point.effort}) {
      archive.check(list->empty() || list->size() == joints);
    }
    archive.check(!point.positions.empty() || !hasBegun_);
  }
  for (const auto* list : {&before_.velocities, &before_.accelerations, &before_.effort}) {
    archive.check(list->empty() || list->size() == joints);
  }
}

}  // namespace pongsim::ros2
