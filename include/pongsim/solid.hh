#pragma once

#include <Eigen/Geometry>

#include "pongsim/export.hh"
#include "pongsim/shape.hh"
#include "pongsim/types.hh"

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

 private:
  Shape shape_;
  Volume volume_;
  Eigen::AlignedBox3d bounds_;
  double radius_ = 0;
  /// Of triangles whose outside is inside: -1.
  double orientation_ = 1;
};

}  // namespace pongsim
