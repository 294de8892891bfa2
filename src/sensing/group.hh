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

/// Objects that are found by the boxes around them: by Embree, or where there are a few by looking at each, for its
/// tree costs more than it spares them. The answers are the same.
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
  /// Of these looking at each takes 2 µs for 64 beams, making their tree and going through it 5.
  static constexpr std::size_t kFew = 8;

  /// @return The box around an object, wider by as far as a beam in single precision goes astray; empty where it is too
  /// far away to be seen.
  Eigen::AlignedBox3d wideBox(const Object& object) const;
  void castAtFew(BeamQuery& query) const;
  static void tellBounds(const RTCBoundsFunctionArguments* arguments);
  static void intersect(const RTCIntersectFunctionNArguments* arguments);

  std::vector<Object> objects_;
  /// Around each object, where there are a few.
  std::vector<Eigen::AlignedBox3d> boxes_;
  double reach_ = 1;
  ScenePointer scene_;
  GeometryPointer geometry_;
};

}  // namespace pongsim::sensing
