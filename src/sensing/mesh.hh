#pragma once

#include <memory>

#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"
#include "sensing/embree.hh"
#include "sensing/shape.hh"

namespace pongsim::sensing {

/// A triangle mesh in its own frame. Embree finds candidate triangles in single precision, depending on the processor;
/// the hit is computed in double precision, so that it is the same on every machine.
class Mesh {
 public:
  /// @param triangles At least one.
  Mesh(RTCDevice device, std::shared_ptr<const description::TriangleMesh> triangles);

  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  const std::shared_ptr<const description::TriangleMesh>& triangles() const { return triangles_; }

  /// @return The first hit on the line between `from` and `to`, in lengths of its direction; infinity without one.
  /// Triangles are hit from outside, where their vertices are counter-clockwise, or from either side if `seesInside`.
  double firstHit(const Line& line, double from, double to, bool seesInside) const;

 private:
  static void writeBounds(const RTCBoundsFunctionArguments* arguments);

  std::shared_ptr<const description::TriangleMesh> triangles_;
  Eigen::AlignedBox3d bounds_;
  ScenePointer scene_;
};

}  // namespace pongsim::sensing
