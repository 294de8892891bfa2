#include "assets/figures/skeleton.hh"

#include <algorithm>
#include <cctype>
#include <exception>
#include <iterator>

#include "assets/figures/collada_skeleton.hh"
#include "assets/meshes/mesh_file.hh"
#include "base/regular_file.hh"
#include "pongsim/math.hh"

namespace pongsim::assets {

namespace {

/// @return The rotation a part of the shorter way from one to another, at an even pace.
Quaternion turnedPart(const Quaternion& from, double part, const Quaternion& to) {
  const Quaternion way = from.conjugate() * to;
  const double sign = way.w() < 0 ? -1 : 1;
  const double sine = way.vec().norm();
  if (sine < 1e-12) return from;
  const double angle = 2 * math::atan2(sine, sign * way.w());
  return (from * rotationAbout(sign * way.vec() / sine, part * angle)).normalized();
}

}  // namespace

Quaternion Track::rotationIn(const Eigen::Affine3d& transform) {
  Matrix3 axes = transform.linear();
  for (int i = 0; i < 3; ++i) {
    const double length = axes.col(i).norm();
    if (!(length > 0)) return Quaternion::Identity();
    axes.col(i) /= length;
  }
  return Quaternion(axes).normalized();
}

void Track::add(double time, const Eigen::Affine3d& X_ParentBone) {
  frames_[time] = {X_ParentBone.translation(), rotationIn(X_ParentBone)};
}

Pose Track::at(double time) const {
  if (frames_.empty()) return {};
  const auto next = frames_.upper_bound(time);
  if (next == frames_.begin()) return next->second;
  const auto last = std::prev(next);
  if (next == frames_.end()) return last->second;
  const double share = (time - last->first) / (next->first - last->first);
  return {last->second.position + share * (next->second.position - last->second.position),
          turnedPart(last->second.rotation, share, next->second.rotation)};
}

double Track::timeAtX(double x) const {
  const auto next = std::ranges::find_if(frames_, [x](const auto& each) { return each.second.position.x() >= x; });
  if (next == frames_.end()) return length();
  if (next == frames_.begin()) return next->first;
  const auto last = std::prev(next);
  const double from = last->second.position.x(), to = next->second.position.x();
  return last->first + (next->first - last->first) * (x - from) / (to - from);
}

void Track::scale(double factor) {
  for (auto& [time, pose] : frames_) pose.position *= factor;
}

void Motion::scale(double factor) {
  for (auto& [bone, track] : tracks) track.scale(factor);
}

double Motion::length() const {
  double length = 0;
  for (const auto& [bone, track] : tracks) length = std::max(length, track.length());
  return length;
}

std::variant<std::optional<Skeleton>, Problem> readSkeleton(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (ending != ".dae")
    return Problem{"is no Collada file (.dae)",
                   "skins are read from these only, animations also from BVH files (.bvh)"};
  auto read = base::readRegularFile(file, kLargestMeshFile);
  if (auto* unreadable = std::get_if<base::Unreadable>(&read)) return Problem{std::move(unreadable->reason), {}};
  try {
    return colladaSkeleton(std::get<std::string>(read));
  } catch (const std::exception& problem) {
    return Problem{"has a skeleton that can't be read", problem.what()};
  }
}

}  // namespace pongsim::assets
