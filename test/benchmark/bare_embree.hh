#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "description/world.hh"
#include "pongsim/types.hh"

namespace pongsim::benchmark {

/// The visuals of a world's links as triangles in one scene of Embree's, in single precision, and nothing around it.
class BareEmbree {
 public:
  /// @param world Of boxes, spheres, cylinders and planes.
  explicit BareEmbree(const description::World& world);
  ~BareEmbree();

  /// @return How many triangles there are.
  std::size_t size() const { return size_; }

  /// Casts one beam after another from a place in the world.
  /// @param ranges One a direction.
  void cast(const Vector3& origin, const std::vector<Vector3>& directions, double farthest,
            std::vector<float>& ranges) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  std::size_t size_ = 0;
};

}  // namespace pongsim::benchmark
