#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "pongsim/ball.hh"
#include "pongsim/export.hh"
#include "pongsim/prism.hh"
#include "pongsim/shape.hh"
#include "pongsim/types.hh"
#include "pongsim/volume_moments.hh"

namespace pongsim {

/// A part of space.
struct Volume {
  /// [m^3]
  double size = 0;
  /// Its centroid; zero where there is nothing [m].
  Vector3 center = Vector3::Zero();
};

/// What a shape encloses, and how much of it lies below a plane. That of boxes, spheres, cylinders, capsules,
/// ellipsoids and of closed surfaces of triangles is exact but for rounding.
class PONGSIM_API Solid {
 public:
  /// A plane, ground and `NoShape` enclose nothing.
  explicit Solid(Shape shape);

  const Shape& shape() const { return shape_; }
  /// @return All of it, in the shape's frame. A surface that is not closed is taken as the cone from the frame's origin
  /// to it, as ignition-common does.
  const Volume& volume() const { return volume_; }
  /// @return The smallest box around it along the axes of the shape's frame [m]; an empty one for what has no volume.
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// @return The largest distance from the centre of `bounds()` that any part of it can have [m].
  double radius() const { return radius_; }
  /// @return Whether the shape has an inside: triangles do where each edge lies between two of them that turn the same
  /// way. Takes a while for a large mesh.
  bool isClosed() const;
  /// @param up Unit vector in the shape's frame.
  /// @param height Of the plane along `up`, from the origin of that frame [m].
  /// @return The part that lies below the plane, in the shape's frame: all points p with `up . p <= height`.
  Volume below(const Vector3& up, double height) const;
  /// @return The volume of the same part, and that multiplied by its centroid: what adds up, and takes less time.
  VolumeMoments momentsBelow(const Vector3& up, double height) const {
    if (ball_.radius > 0) return ball_.below(up, height);
    if (const std::optional<VolumeMoments> part = prism_.below(up, height)) return *part;
    return momentsBelowElsewhere(up, height);
  }
  /// As `momentsBelow`, for a level plane and a solid that is turned.
  /// @param height Of the plane above the origin of the shape's frame [m].
  /// @return What lies below the plane, its moments along the axes of the world about the origin of the shape's frame.
  VolumeMoments momentsBelowLevel(const Quaternion& R_WorldSolid, double height) const {
    if (ball_.radius > 0) return ball_.below(Vector3::UnitZ(), height);
    if (const std::optional<VolumeMoments> part = prism_.belowLevel(R_WorldSolid, height)) return *part;
    return momentsBelowLevelElsewhere(R_WorldSolid, height);
  }
  /// @return Whether the centroid of all of it is the origin of the shape's frame.
  bool isCentered() const { return isCentered_; }
  /// @return Those of all of it.
  const VolumeMoments& moments() const { return moments_; }

 private:
  VolumeMoments oriented(const VolumeMoments& moments) const;
  /// What no short formula tells.
  VolumeMoments momentsBelowElsewhere(const Vector3& up, double height) const;
  VolumeMoments momentsBelowLevelElsewhere(const Quaternion& R_WorldSolid, double height) const;

  Shape shape_;
  Volume volume_;
  VolumeMoments moments_;
  bool isCentered_ = true;
  /// Of a sphere, and of what has sides along an axis; else nothing.
  Ball ball_;
  Prism prism_;
  Eigen::AlignedBox3d bounds_;
  double radius_ = 0;
  /// Of triangles whose outside is inside: -1.
  double orientation_ = 1;
};

}  // namespace pongsim
