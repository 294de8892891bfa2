#pragma once

#include <memory>

#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"
#include "sensing/embree.hh"
#include "sensing/shape.hh"

namespace pongsim::sensing {

/// Triangles that beams meet, in their own frame. Embree finds which of them may be met, in single precision and by
/// what the processor has; which is met and where is reckoned in double precision, so that it is the same everywhere.
class Mesh {
 public:
  /// @param triangles At least one.
  Mesh(RTCDevice device, std::shared_ptr<const description::TriangleMesh> triangles);

  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  /// @return The first point of the line between `from` and `to`, in lengths of its direction, where it meets a
  /// triangle from outside, which is where its corners go round counter-clockwise, or from either side if `seesInside`;
  /// infinity where there is none.
  double firstHit(const Line& line, double from, double to, bool seesInside) const;

 private:
  static void tellBounds(const RTCBoundsFunctionArguments* arguments);

  std::shared_ptr<const description::TriangleMesh> triangles_;
  Eigen::AlignedBox3d bounds_;
  ScenePointer scene_;
};

}  // namespace pongsim::sensing
