#include "world/actor_motion.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pongsim/math.hh"

namespace pongsim::world {

namespace {

using description::Trajectory;
using description::Waypoint;

/// @return Half of the rotation, as a vector along its axis; of the two ways the shorter one.
Vector3 logarithm(const Quaternion& rotation) {
  const double sign = rotation.w() < 0 ? -1 : 1;
  const double length = rotation.vec().norm();
  if (length < 1e-12) return Vector3::Zero();
  return sign * rotation.vec() * (math::atan2(length, sign * rotation.w()) / length);
}

Quaternion exponential(const Vector3& half) {
  const double angle = half.norm();
  if (angle < 1e-12) return Quaternion::Identity();
  return rotationAbout(half / angle, 2 * angle);
}

/// @return The rotation a part `t` of the shorter way from one to another, at an even pace.
Quaternion between(const Quaternion& from, double t, const Quaternion& to) {
  // Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985; straight on where they are next to the same
  const double cosine = from.dot(to), size = std::abs(cosine);
  double before = 1 - t, behind = t;
  if (size < 1 - 1e-15) {
    const double angle = math::acos(size), sine = math::sin(angle);
    before = math::sin((1 - t) * angle) / sine;
    behind = math::sin(t * angle) / sine;
  }
  return Quaternion(before * from.coeffs() + (cosine < 0 ? -behind : behind) * to.coeffs());
}

/// The way through the waypoints of a trajectory, in the order of their times.
class Way {
 public:
  explicit Way(const Trajectory& trajectory) : points_(trajectory.waypoints), share_(1 - trajectory.tension) {
    std::ranges::stable_sort(points_, {}, &Waypoint::time);
    const Pose& first = poseOf(0);
    const Pose& last = poseOf(points_.size() - 1);
    isRound_ = points_.size() > 2 && first.position == last.position;
    turnsRound_ = points_.size() > 2 && first.rotation.coeffs() == last.rotation.coeffs();
  }

  Pose at(double time) const {
    if (time <= points_.front().time) return poseOf(0);
    if (time >= points_.back().time) return poseOf(points_.size() - 1);
    const auto next = std::ranges::upper_bound(points_, time, {}, &Waypoint::time);
    const auto i = static_cast<std::size_t>(next - points_.begin()) - 1;
    const double t = (time - points_[i].time) / (points_[i + 1].time - points_[i].time);
    return {positionBetween(i, t), rotationBetween(i, t)};
  }

 private:
  const Pose& poseOf(std::size_t i) const { return points_[i].X_ActorWaypoint; }

  /// @return The waypoint before and the one behind; itself at an open end.
  std::size_t before(std::size_t i, bool isClosed) const { return i > 0 ? i - 1 : isClosed ? points_.size() - 2 : 0; }
  std::size_t behind(std::size_t i, bool isClosed) const { return i + 1 < points_.size() ? i + 1 : isClosed ? 1 : i; }

  Vector3 tangent(std::size_t i) const {
    return share_ / 2 * (poseOf(behind(i, isRound_)).position - poseOf(before(i, isRound_)).position);
  }

  Vector3 positionBetween(std::size_t i, double t) const {
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * poseOf(i).position + (3 * t2 - 2 * t3) * poseOf(i + 1).position +
           (t3 - 2 * t2 + t) * tangent(i) + (t3 - t2) * tangent(i + 1);
  }

  Quaternion control(std::size_t i) const {
    const Quaternion& rotation = poseOf(i).rotation;
    const Quaternion back = rotation.conjugate();
    const Vector3 sum = logarithm(back * poseOf(behind(i, turnsRound_)).rotation) +
                        logarithm(back * poseOf(before(i, turnsRound_)).rotation);
    return rotation * exponential(-sum / 4);
  }

  Quaternion rotationBetween(std::size_t i, double t) const {
    const Quaternion direct = between(poseOf(i).rotation, t, poseOf(i + 1).rotation);
    return between(direct, 2 * t * (1 - t), between(control(i), t, control(i + 1))).normalized();
  }

  std::vector<Waypoint> points_;
  double share_;
  bool isRound_ = false;
  bool turnsRound_ = false;
};

double durationOf(const Trajectory& trajectory) {
  double duration = 0;
  for (const Waypoint& point : trajectory.waypoints) duration = std::max(duration, point.time);
  return duration;
}

/// A trajectory, and the time on it.
struct Progress {
  /// Null: without waypoints nobody goes anywhere.
  const Trajectory* trajectory = nullptr;
  double time = 0;
};

Progress progressAt(const description::Actor& actor, Time time) {
  double whole = 0;
  for (const Trajectory& trajectory : actor.trajectories) whole += durationOf(trajectory);
  double rest = std::max(0.0, toSeconds(time) - actor.startDelay);
  if (rest > whole) rest = actor.loops && whole > 0 ? std::fmod(rest, whole) : whole;

  const Trajectory* current = nullptr;
  double begin = 0;
  for (const Trajectory& trajectory : actor.trajectories) {
    if (trajectory.waypoints.empty()) continue;
    if (current != nullptr) {
      if (rest <= begin + durationOf(*current)) break;
      begin += durationOf(*current);
    }
    current = &trajectory;
  }
  return {current, rest - begin};
}

/// @return How far it is from waypoint to waypoint until then; as in Fortress straight, and at an even pace.
double distanceAt(const Progress& progress) {
  std::vector<Waypoint> points = progress.trajectory->waypoints;
  std::ranges::stable_sort(points, {}, &Waypoint::time);
  double distance = 0;
  for (std::size_t i = 0; i + 1 < points.size() && points[i].time < progress.time; ++i) {
    const double length = (points[i + 1].X_ActorWaypoint.position - points[i].X_ActorWaypoint.position).norm();
    const double duration = points[i + 1].time - points[i].time;
    distance += duration > 0 ? length * std::min(1.0, (progress.time - points[i].time) / duration) : 0;
  }
  return distance;
}

}  // namespace

Pose actorPose(const description::Actor& actor, Time time) {
  const Progress progress = progressAt(actor, time);
  if (progress.trajectory == nullptr) return actor.X_WorldActor;
  return actor.X_WorldActor * Way(*progress.trajectory).at(progress.time);
}

Pose actorPose(const description::Actor& actor, const State& state) {
  const auto moved = std::ranges::find(state.actors, &actor, &ActorState::description);
  return moved == state.actors.end() ? actorPose(actor, state.time) : moved->X_WorldActor;
}

assets::Gait actorGait(const description::Actor& actor, const State& state) {
  assets::Gait gait;
  const auto moved = std::ranges::find(state.actors, &actor, &ActorState::description);
  if (moved != state.actors.end()) {
    gait.animation = moved->animation;
    gait.time = toSeconds(moved->animationTime);
    return gait;
  }
  gait.loops = actor.loops;
  const Progress progress = progressAt(actor, state.time);
  if (progress.trajectory == nullptr) {
    if (!actor.trajectories.empty()) gait.animation = actor.trajectories.front().type;
    gait.time = std::max(0.0, toSeconds(state.time) - actor.startDelay);
    gait.isOnPath = false;
    return gait;
  }
  gait.animation = progress.trajectory->type;
  gait.time = progress.time;
  gait.distance = distanceAt(progress);
  return gait;
}

}  // namespace pongsim::world
