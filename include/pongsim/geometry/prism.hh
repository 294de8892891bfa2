#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "pongsim/geometry/shape.hh"
#include "pongsim/geometry/volume_moments.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A solid centred on the origin whose cross sections along an axis are all equal between its ends: a box along each of
/// its axes, a cylinder, or a capsule, whose ends are round. If a plane cuts only the sides along that axis, as the
/// water surface does for most upright floating bodies, the volume below it has a closed formula: a slanting cut
/// removes on one side of the middle what it adds on the other.
class Prism {
 public:
  /// A prism that no plane cuts.
  Prism() = default;

  explicit Prism(const BoxShape& box) : kind_(Kind::kBox), size_(box.size) {
    spread_ = box.size.cwiseProduct(box.size) / 12;
    area_ = {box.size.y() * box.size.z(), box.size.z() * box.size.x(), box.size.x() * box.size.y()};
  }

  explicit Prism(const CylinderShape& cylinder)
      : kind_(Kind::kRound), size_(2 * cylinder.radius, 2 * cylinder.radius, cylinder.length) {
    const double square = cylinder.radius * cylinder.radius;
    spread_ = Vector3(square / 4, square / 4, 0);
    area_.z() = std::numbers::pi * square;
  }

  explicit Prism(const CapsuleShape& capsule) : Prism(CylinderShape{capsule.radius, capsule.length}) {
    endVolume_ = std::numbers::pi * 2 / 3 * capsule.radius * capsule.radius * capsule.radius;
    // the centroid of half a ball is 3/8 of the radius from its middle
    endFirst_ = endVolume_ * (capsule.length / 2 + capsule.radius * 3 / 8);
  }

  /// @param up Unit vector in the frame of the shape.
  /// @param height Height of a plane along `up`, from the origin of that frame [m].
  /// @return The part below the plane, if the plane only cuts the sides along an axis; otherwise nothing.
  std::optional<VolumeMoments> below(const Vector3& up, double height) const {
    if (kind_ == Kind::kNone) return std::nullopt;
    const Axes axes = axesFor(up);
    const std::optional<Cut> cut = cutBy(axes, up[axes.along], up[axes.across1], up[axes.across2], height);
    if (!cut) return std::nullopt;
    VolumeMoments part;
    part.volume = cut->volume;
    part.first[axes.along] = cut->along;
    part.first[axes.across1] = cut->tilt1 * up[axes.across1];
    part.first[axes.across2] = cut->tilt2 * up[axes.across2];
    return part;
  }

  /// Like `below`, for a horizontal plane and a rotated solid.
  /// @param height Height of the plane above the origin of the solid [m].
  /// @return The part below the plane, with moments in the axes of the world about the origin of the solid.
  std::optional<VolumeMoments> belowLevel(const Quaternion& R_WorldSolid, double height) const {
    switch (kind_) {
      case Kind::kNone:
        break;
      case Kind::kBox:
        return boxBelowLevel(R_WorldSolid, height);
      case Kind::kRound:
        return roundBelowLevel(R_WorldSolid, height);
    }
    return std::nullopt;
  }

 private:
  enum class Kind { kNone, kBox, kRound };

  /// The axis along the sides, and the two across it.
  struct Axes {
    Eigen::Index along, across1, across2;
  };

  /// The part below a plane: its volume, and the moments along the axis and across it, the latter per component of the
  /// plane's normal.
  struct Cut {
    double volume, along, tilt1, tilt2;
  };

  Axes axesFor(const Vector3& up) const {
    constexpr std::array<Eigen::Index, 3> kNext{1, 2, 0};
    const Eigen::Index along = kind_ == Kind::kBox ? steepest(up) : 2;
    const Eigen::Index across1 = kNext[static_cast<std::size_t>(along)];
    return {along, across1, kNext[static_cast<std::size_t>(across1)]};
  }

  /// @param upAlong,up1,up2 Components of the plane's normal along the axes.
  std::optional<Cut> cutBy(const Axes& axes, double upAlong, double up1, double up2, double height) const {
    const double length = size_[axes.along];
    const double stretch = 1 / std::abs(upAlong);
    // by how much the plane falls along the axis for each metre across, and how much is below it in the middle
    const double slope1 = up1 * stretch, slope2 = up2 * stretch;
    const double middle = height * stretch + length / 2;
    const double reach = kind_ == Kind::kBox
                             ? (std::abs(slope1) * size_[axes.across1] + std::abs(slope2) * size_[axes.across2]) / 2
                             : std::sqrt(slope1 * slope1 + slope2 * slope2) * size_[axes.across1] / 2;
    // false, too, for what is not a number, as where the plane runs along the axis
    if (!(reach <= middle && middle <= length - reach)) return std::nullopt;
    const double area = area_[axes.along];
    const double spread1 = area * spread_[axes.across1], spread2 = area * spread_[axes.across2];
    const double along =
        (area * middle * (middle - length) + slope1 * slope1 * spread1 + slope2 * slope2 * spread2) / 2 - endFirst_;
    return Cut{area * middle + endVolume_, upAlong < 0 ? -along : along, -stretch * spread1, -stretch * spread2};
  }

  /// The axes of the box in the world are the columns of its rotation. Weighted by their upward components they add up
  /// to the vertical, which saves computing the last one.
  std::optional<VolumeMoments> boxBelowLevel(const Quaternion& R_WorldSolid, double height) const {
    const Matrix3 R = R_WorldSolid.toRotationMatrix();
    const Vector3 up = R.row(2);
    const Axes axes = axesFor(up);
    const std::optional<Cut> cut = cutBy(axes, up[axes.along], up[axes.across1], up[axes.across2], height);
    if (!cut) return std::nullopt;
    VolumeMoments part;
    part.volume = cut->volume;
    part.first = (cut->along - cut->tilt2 * up[axes.along]) * R.col(axes.along) +
                 ((cut->tilt1 - cut->tilt2) * up[axes.across1]) * R.col(axes.across1);
    part.first.z() += cut->tilt2;
    return part;
  }

  /// The same for solids of revolution.
  std::optional<VolumeMoments> roundBelowLevel(const Quaternion& R_WorldSolid, double height) const {
    const Quaternion& q = R_WorldSolid;
    const Vector3 axis(2 * (q.x() * q.z() + q.w() * q.y()), 2 * (q.y() * q.z() - q.w() * q.x()),
                       1 - 2 * (q.x() * q.x() + q.y() * q.y()));
    const double across = std::sqrt(std::max(0.0, 1 - axis.z() * axis.z()));
    const std::optional<Cut> cut = cutBy({2, 0, 1}, axis.z(), across, 0, height);
    if (!cut) return std::nullopt;
    VolumeMoments part;
    part.volume = cut->volume;
    part.first = (cut->along - cut->tilt1 * axis.z()) * axis;
    part.first.z() += cut->tilt1;
    return part;
  }

  /// @return The axis with the largest component of a vector.
  static Eigen::Index steepest(const Vector3& vector) {
    const double x = std::abs(vector.x()), y = std::abs(vector.y()), z = std::abs(vector.z());
    if (z >= x && z >= y) return 2;
    return x >= y ? 0 : 1;
  }

  Kind kind_ = Kind::kNone;
  /// Lengths of the sides along each axis [m].
  Vector3 size_ = Vector3::Zero();
  /// Mean square distance from the middle of a cross section, along each axis [m^2].
  Vector3 spread_ = Vector3::Zero();
  /// Areas of the cross sections along each axis [m^2].
  Vector3 area_ = Vector3::Zero();
  /// Of each round end: its volume [m^3], and that times its centroid's distance from the origin [m^4].
  double endVolume_ = 0, endFirst_ = 0;
};

}  // namespace pongsim
