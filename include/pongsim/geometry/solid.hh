#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "pongsim/export.hh"
#include "pongsim/geometry/ball.hh"
#include "pongsim/geometry/prism.hh"
#include "pongsim/geometry/shape.hh"
#include "pongsim/geometry/volume_moments.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A volume and its centroid.
struct Volume {
  /// [m^3]
  double size = 0;
  /// Centroid [m]; zero for an empty volume.
  Vector3 center = Vector3::Zero();
};

/// The volume of a shape, and its part below a plane. Exact up to rounding for boxes, spheres, cylinders, capsules,
/// ellipsoids and closed triangle meshes.
class PONGSIM_API Solid {
 public:
  /// Planes, heightmaps and `NoShape` have no volume.
  explicit Solid(Shape shape);

  const Shape& shape() const { return shape_; }
  /// @return The whole volume, in the shape's frame. An open mesh counts as the cone from the frame's origin to its
  /// surface, as in ignition-common.
  const Volume& volume() const { return volume_; }
  /// @return The axis-aligned bounding box in the shape's frame [m]; empty without volume.
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// @return An upper bound of the distance of any part from the centre of `bounds()` [m].
  double radius() const { return radius_; }
  /// @return Whether the shape has an inside. A mesh does if each edge joins two triangles of the same orientation.
  /// Slow for large meshes.
  bool isClosed() const;
  /// @param up Unit vector in the shape's frame.
  /// @param height Height of the plane along `up`, from the origin of that frame [m].
  /// @return The part below the plane, in the shape's frame: all points p with `up . p <= height`.
  Volume below(const Vector3& up, double height) const;
  /// @return The same part as volume and volume times centroid, which are additive and faster to compute.
  VolumeMoments momentsBelow(const Vector3& up, double height) const {
    if (ball_.radius > 0) return ball_.below(up, height);
    if (const std::optional<VolumeMoments> part = prism_.below(up, height)) return *part;
    return momentsBelowElsewhere(up, height);
  }
  /// Like `momentsBelow`, for a horizontal plane and a rotated solid.
  /// @param height Height of the plane above the origin of the shape's frame [m].
  /// @return The part below the plane, with moments in the axes of the world about the origin of the shape's frame.
  VolumeMoments momentsBelowLevel(const Quaternion& R_WorldSolid, double height) const {
    if (ball_.radius > 0) return ball_.below(Vector3::UnitZ(), height);
    if (const std::optional<VolumeMoments> part = prism_.belowLevel(R_WorldSolid, height)) return *part;
    return momentsBelowLevelElsewhere(R_WorldSolid, height);
  }
  /// @return Whether the centroid is the origin of the shape's frame.
  bool isCentered() const { return isCentered_; }
  /// @return The moments of the whole volume.
  const VolumeMoments& moments() const { return moments_; }

 private:
  VolumeMoments oriented(const VolumeMoments& moments) const;
  /// For cases without a closed formula.
  VolumeMoments momentsBelowElsewhere(const Vector3& up, double height) const;
  VolumeMoments momentsBelowLevelElsewhere(const Quaternion& R_WorldSolid, double height) const;

  Shape shape_;
  Volume volume_;
  VolumeMoments moments_;
  bool isCentered_ = true;
  /// For a sphere, and for shapes with sides along an axis; otherwise empty.
  Ball ball_;
  Prism prism_;
  Eigen::AlignedBox3d bounds_;
  double radius_ = 0;
  /// -1 for a mesh with inverted triangles.
  double orientation_ = 1;
};

}  // namespace pongsim
