#pragma once

#include <LinearMath/btTransform.h>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

inline btVector3 toBullet(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline btQuaternion toBullet(const Quaternion& q) { return {q.x(), q.y(), q.z(), q.w()}; }
inline btTransform toBullet(const Pose& X) { return btTransform(toBullet(X.rotation), toBullet(X.position)); }

inline Vector3 fromBullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline Quaternion fromBullet(const btQuaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
inline Pose fromBullet(const btTransform& X) { return {fromBullet(X.getOrigin()), fromBullet(X.getRotation())}; }

/// @return Whether each component is at most `bound`.
inline bool isWithin(const btVector3& vector, double bound) {
  return vector.absolute()[vector.absolute().maxAxis()] <= bound;
}

inline void transferVector(StateArchive& archive, btVector3& vector) {
  for (int i = 0; i < 3; ++i) archive(vector[i]);
}

}  // namespace pongsim::physics
