#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "description/link.hh"

namespace pongsim::physics {

/// Surfaces and simple shapes shared by links with the same ones: a thousand robots share those of one, which then stay
/// in the processor's nearest caches. Unused ones are dropped.
class SharedShapes {
 public:
  std::shared_ptr<const description::Surface> surface(const description::Surface& surface);

  /// @param surface As returned by `surface`; becomes the shape's user pointer.
  /// @param collision The collision's number in its link; becomes the shape's user index.
  /// @return Null if it is not a simple shape but triangles, or nothing.
  std::shared_ptr<btCollisionShape> shape(const description::Geometry& geometry, const description::Surface& surface,
                                          int collision);

  /// Number of entries, some of which may be unused.
  std::size_t size() const { return surfaces_.size() + shapes_.size(); }

 private:
  struct ShapeEntry {
    description::Geometry geometry;
    const description::Surface* surface;
    int collision;
    std::weak_ptr<btCollisionShape> shape;
    bool expired() const { return shape.expired(); }
  };
  /// Keyed by hash; several entries can have the same one.
  template <class Entry>
  using Table = std::unordered_multimap<std::uint64_t, Entry>;

  Table<std::weak_ptr<const description::Surface>> surfaces_;
  Table<ShapeEntry> shapes_;
  /// How many entries each table may have before unused ones are looked for.
  std::size_t mostSurfaces_ = 64;
  std::size_t mostShapes_ = 64;
};

}  // namespace pongsim::physics
