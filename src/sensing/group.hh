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

/// What is farther from the world's origin is not seen [m].
inline constexpr double kMostDistance = 1e15;

/// How many beams are cast at a time: side by side they go through the same boxes.
inline constexpr std::size_t kBeamsAtATime = 8;

/// A beam, and the answer so far.
struct Beam {
  /// In the world frame, its direction of length one.
  Line line;
  /// What is farther is not looked for [m].
  double range;
  const Object* hit;
};

/// What is asked at a time.
struct BeamQuery {
  // stands first, for Embree hands its address on
  RTCIntersectContext context;
  /// The model that is not seen nearer than `minRange` [m].
  ModelId owner;
  double minRange;
  std::uint32_t visibilityMask;
  std::array<Beam, kBeamsAtATime> beams;
  /// Of which so many count.
  std::size_t count;
};

/// Objects that Embree finds by the boxes around them.
class Group {
 public:
  explicit Group(RTCDevice device);
  // Embree knows its address
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  /// Empty, changed or moved as one likes, followed by `commit`.
  std::vector<Object>& objects() { return objects_; }

  /// @param reach How far from the world's origin beams begin, at most [m].
  void commit(double reach);

  /// Answers each beam with an object where that is nearer than the answer so far. Of two that are met at the same
  /// place the one that comes first in the scene counts.
  void cast(BeamQuery& query) const;

 private:
  static void tellBounds(const RTCBoundsFunctionArguments* arguments);
  static void intersect(const RTCIntersectFunctionNArguments* arguments);

  std::vector<Object> objects_;
  double reach_ = 1;
  ScenePointer scene_;
  GeometryPointer geometry_;
};

}  // namespace pongsim::sensing
