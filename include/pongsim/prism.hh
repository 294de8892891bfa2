#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "pongsim/shape.hh"
#include "pongsim/types.hh"
#include "pongsim/volume_moments.hh"

namespace pongsim {

/// A solid about the origin whose slices across an axis are all the same between its ends: a box along each of its
/// axes, a cylinder, and a capsule, whose ends are round. Of a plane that cuts such sides alone, as the surface of the
/// sea does with most that floats upright, what lies below it is a closed formula: a slanting end takes away on one
/// side of the middle what it adds on the other.
class Prism {
 public:
  /// One that no plane cuts.
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
  /// @param height Of a plane along `up`, from the origin of that frame [m].
  /// @return What lies below the plane, where that cuts the sides along an axis alone; else nothing.
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

  /// As `below`, for a level plane and a solid that is turned.
  /// @param height Of the plane above the origin of the solid [m].
  /// @return What lies below the plane, its moments along the axes of the world about the origin of the solid.
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

  /// One that the sides run along, and those across it.
  struct Axes {
    Eigen::Index along, across1, across2;
  };

  /// What is below a plane: its volume, and the moments along the axis and across it, there by the component of the
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

  /// @param upAlong,up1,up2 The components of the plane's normal along the axes.
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

  /// The axes of the box seen from the world are the columns of its rotation; of the three, each by its component
  /// upwards, the sum is upright, which spares the last one.
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

  /// Likewise of what looks the same from all sides across its axis.
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

  /// @return The axis along which a vector is longest.
  static Eigen::Index steepest(const Vector3& vector) {
    const double x = std::abs(vector.x()), y = std::abs(vector.y()), z = std::abs(vector.z());
    if (z >= x && z >= y) return 2;
    return x >= y ? 0 : 1;
  }

  Kind kind_ = Kind::kNone;
  /// Of the sides, along each axis [m].
  Vector3 size_ = Vector3::Zero();
  /// Mean square of the distance from the middle of a slice, along each axis [m^2].
  Vector3 spread_ = Vector3::Zero();
  /// Of the slices across each axis [m^2].
  Vector3 area_ = Vector3::Zero();
  /// Of what is round at each end: its volume [m^3], and that times how far its centroid is from the origin [m^4].
  double endVolume_ = 0, endFirst_ = 0;
};

}  // namespace pongsim
