#include "rendering/projection.hh"

#include <cmath>

namespace pongsim::rendering {

namespace {

/// From the camera's axes to clip coordinates x, y and w.
Matrix3 flatFromCamera(const PictureView& view) {
  const double w = view.width, h = view.height;
  Matrix3 flat;
  // x is ahead, y to the left, z up
  flat << 2 * view.cx / w - 1, -2 * view.fx / w, -2 * view.skew / w,  //
      2 * view.cy / h - 1, 0, -2 * view.fy / h,                       //
      1, 0, 0;
  return flat;
}

}  // namespace

Eigen::Matrix4d clipFromPlace(const PictureView& view) {
  const Matrix3 flat = flatFromCamera(view) * view.X_WorldEye.rotation.toRotationMatrix().transpose();
  const Vector3 ahead = view.X_WorldEye.rotation * Vector3::UnitX();
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip.row(0).head<3>() = flat.row(0);
  clip.row(1).head<3>() = flat.row(1);
  clip.row(3).head<3>() = flat.row(2);
  if (std::isfinite(view.far)) {
    clip.row(2).head<3>() = -view.near / (view.far - view.near) * ahead;
    clip(2, 3) = view.near * view.far / (view.far - view.near);
  } else {
    clip(2, 3) = view.near;
  }
  return clip;
}

Matrix3 directionFromClip(const PictureView& view) {
  return view.X_WorldEye.rotation.toRotationMatrix() * flatFromCamera(view).inverse();
}

bool mayBeSeen(const Eigen::Matrix4d& clipFromPlace, const Vector3& middle, double radius) {
  const auto isOutside = [&](const Eigen::RowVector4d& plane) {
    const double length = plane.head<3>().norm();
    return length > 0 && plane.head<3>() * middle + plane[3] < -radius * length;
  };
  const auto& m = clipFromPlace;
  return !isOutside(m.row(3) + m.row(0)) && !isOutside(m.row(3) - m.row(0)) && !isOutside(m.row(3) + m.row(1)) &&
         !isOutside(m.row(3) - m.row(1)) && !isOutside(m.row(3) - m.row(2)) && !isOutside(m.row(2));
}

}  // namespace pongsim::rendering
