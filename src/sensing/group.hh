#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pongsim/types.hh"
#include "sensing/embree.hh"
#include "sensing/object.hh"
#include "sensing/shape.hh"

namespace pongsim::sensing {

/// Objects farther from the world's origin are invisible [m].
inline constexpr double kMostDistance = 1e15;

/// Number of beams cast together: they traverse the same boxes.
inline constexpr std::size_t kBeamsAtATime = 8;

/// A beam and its closest hit so far.
struct Beam {
  /// World frame, with a unit direction.
  Line line;
  /// Limit of the search [m].
  double range;
  const Object* hit;
};

/// Beams that are cast together.
struct BeamQuery {
  // First member, since Embree passes its address on.
  RTCIntersectContext context;
  /// The model that is ignored below `minRange` [m].
  ModelId owner;
  double minRange;
  std::uint32_t visibilityMask;
  std::array<Beam, kBeamsAtATime> beams;
  /// Number of beams.
  std::size_t count;
};

/// Objects found by their bounding boxes: by Embree, or, if there are only a few, by checking each, which is faster
/// than a tree. The results are the same.
class Group {
 public:
  explicit Group(RTCDevice device);
  // Embree holds its address.
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  /// May be changed freely, followed by `commit`.
  std::vector<Object>& objects() { return objects_; }

  /// @param reach Largest distance of beam origins from the world's origin [m].
  void commit(double reach);

  /// Updates each beam with a closer hit. Of two objects hit at the same distance, the one that comes first in the
  /// scene counts.
  void cast(BeamQuery& query) const;

 private:
  /// For these, checking each object takes 2 µs for 64 beams, a tree 5.
  static constexpr std::size_t kFew = 8;

  /// @return The bounding box of an object, enlarged by the error of beams in single precision; empty if it is too far
  /// away to be visible.
  Eigen::AlignedBox3d wideBox(const Object& object) const;
  void castAtFew(BeamQuery& query) const;
  static void writeBounds(const RTCBoundsFunctionArguments* arguments);
  static void intersect(const RTCIntersectFunctionNArguments* arguments);

  std::vector<Object> objects_;
  /// Of each object, if there are only a few.
  std::vector<Eigen::AlignedBox3d> boxes_;
  double reach_ = 1;
  ScenePointer scene_;
  GeometryPointer geometry_;
};

}  // namespace pongsim::sensing
