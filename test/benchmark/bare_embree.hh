#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "description/world.hh"
#include "pongsim/types.hh"

namespace pongsim::benchmark {

/// The visuals of a world's links as triangles in one Embree scene, with nothing around it.
class BareEmbree {
 public:
  /// @param world With boxes, spheres, cylinders and planes only.
  explicit BareEmbree(const description::World& world);
  ~BareEmbree();

  /// @return The number of triangles.
  std::size_t size() const { return size_; }

  /// Casts one beam after another.
  /// @param origin World frame [m].
  /// @param ranges One for each direction.
  void cast(const Vector3& origin, const std::vector<Vector3>& directions, double farthest,
            std::vector<float>& ranges) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  std::size_t size_ = 0;
};

}  // namespace pongsim::benchmark
