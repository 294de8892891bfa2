#include "sensing/group.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pongsim::sensing {

namespace {

// relative error of single precision over a distance, with reserve
constexpr double kMargin = 1e-6;

/// @return The nearest number of single precision that is less, or greater.
float below(double value) { return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity()); }
float above(double value) { return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity()); }

/// @return A range in single precision that is not less.
float notLess(double range) {
  constexpr double kRounding = std::numeric_limits<float>::epsilon();
  return range <= kMostDistance ? static_cast<float>(range * (1 + kRounding)) : std::numeric_limits<float>::infinity();
}

/// Makes the first hit on an object that of the beam, if it is nearer.
/// @return Whether it is.
bool meet(const Object& object, const BeamQuery& query, Beam& beam) {
  const double from = object.owner == query.owner ? query.minRange : 0;
  const double range = object.firstSeenOn(beam.line, from, beam.range);
  const bool isNearer =
      range < beam.range || (range == beam.range && beam.hit != nullptr && object.order < beam.hit->order);
  if (!isNearer) return false;
  beam.range = range;
  beam.hit = &object;
  return true;
}

/// @param inverse Of the line's direction, number by number.
/// @return Whether the line meets the box between its origin and `range`.
bool passes(const Line& line, const Vector3& inverse, const Eigen::AlignedBox3d& box, double range) {
  double enters = 0, leaves = range;
  for (int axis = 0; axis < 3; ++axis) {
    const double one = (box.min()[axis] - line.origin[axis]) * inverse[axis];
    const double other = (box.max()[axis] - line.origin[axis]) * inverse[axis];
    // NaN for a line in a face of the box (0 times infinity) may go either way: the box is larger than the object
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  return enters <= leaves;
}

}  // namespace

Group::Group(RTCDevice device)
    : scene_(embree().newScene(device)), geometry_(embree().newGeometry(device, RTC_GEOMETRY_TYPE_USER)) {
  embree().setSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  embree().setGeometryUserData(geometry_.get(), this);
  embree().setGeometryBoundsFunction(geometry_.get(), writeBounds, nullptr);
  embree().setGeometryIntersectFunction(geometry_.get(), intersect);
  embree().attachGeometry(scene_.get(), geometry_.get());
}

void Group::commit(double reach) {
  reach_ = reach;
  boxes_.clear();
  if (objects_.size() <= kFew) {
    for (const Object& object : objects_) boxes_.push_back(wideBox(object));
    return;
  }
  embree().setGeometryUserPrimitiveCount(geometry_.get(), static_cast<unsigned>(objects_.size()));
  embree().commitGeometry(geometry_.get());
  embree().commitScene(scene_.get());
}

Eigen::AlignedBox3d Group::wideBox(const Object& object) const {
  const Eigen::AlignedBox3d box = object.boundsInWorld();
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!(farthest <= kMostDistance)) return {};
  const Vector3 margin = Vector3::Constant(kMargin * (farthest + reach_));
  return {box.min() - margin, box.max() + margin};
}

void Group::writeBounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  const Eigen::AlignedBox3d box = group.wideBox(group.objects_[arguments->primID]);
  if (box.isEmpty()) {
    // lower bounds above upper ones: Embree ignores the object
    *arguments->bounds_o = {1, 1, 1, 0, -1, -1, -1, 0};
    return;
  }
  const Vector3 &least = box.min(), &most = box.max();
  *arguments->bounds_o = {below(least.x()), below(least.y()), below(least.z()), 0,
                          above(most.x()),  above(most.y()),  above(most.z()),  0};
}

void Group::intersect(const RTCIntersectFunctionNArguments* arguments) {
  const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<BeamQuery*>(arguments->context);
  assert(arguments->primID < group.objects_.size());
  const Object& object = group.objects_[arguments->primID];
  if ((object.visibility & query.visibilityMask) == 0) return;
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, arguments->N);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    Beam& beam = query.beams[RTCRayN_id(rays, arguments->N, i)];
    if (!meet(object, query, beam)) continue;
    float& end = RTCRayN_tfar(rays, arguments->N, i);
    end = std::min(end, notLess(beam.range));
    RTCHitN_geomID(hits, arguments->N, i) = arguments->geomID;
    RTCHitN_primID(hits, arguments->N, i) = arguments->primID;
  }
}

void Group::castAtFew(BeamQuery& query) const {
  // `commit` was called since the objects changed
  assert(boxes_.size() == objects_.size());
  for (std::size_t i = 0; i < query.count; ++i) {
    Beam& beam = query.beams[i];
    const Vector3 inverse = beam.line.direction.cwiseInverse();
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      const Object& object = objects_[k];
      if ((object.visibility & query.visibilityMask) == 0 || boxes_[k].isEmpty()) continue;
      if (passes(beam.line, inverse, boxes_[k], beam.range)) meet(object, query, beam);
    }
  }
}

void Group::cast(BeamQuery& query) const {
  assert(query.count <= kBeamsAtATime);
  if (objects_.size() <= kFew) return castAtFew(query);
  RTCRayHit8 rays{};
  alignas(32) std::array<int, kBeamsAtATime> valid{};
  for (std::size_t i = 0; i < query.count; ++i) {
    const auto& [origin, direction] = query.beams[i].line;
    valid[i] = -1;
    rays.ray.id[i] = static_cast<unsigned>(i);
    rays.ray.org_x[i] = static_cast<float>(origin.x());
    rays.ray.org_y[i] = static_cast<float>(origin.y());
    rays.ray.org_z[i] = static_cast<float>(origin.z());
    rays.ray.dir_x[i] = static_cast<float>(direction.x());
    rays.ray.dir_y[i] = static_cast<float>(direction.y());
    rays.ray.dir_z[i] = static_cast<float>(direction.z());
    rays.ray.tfar[i] = notLess(query.beams[i].range);
    rays.ray.mask[i] = std::numeric_limits<unsigned>::max();
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  embree().intersect8(valid.data(), scene_.get(), &query.context, &rays);
}

}  // namespace pongsim::sensing
