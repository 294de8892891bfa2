#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "description/link.hh"

namespace pongsim::physics {

/// Surfaces and simple shapes of which many links have the same: a thousand robots have those of one, which then stay
/// in the caches nearest to a processor. What nobody has any more is forgotten.
class SharedShapes {
 public:
  std::shared_ptr<const description::Surface> surface(const description::Surface& surface);

  /// @param surface As `surface` gives it; becomes the shape's user pointer.
  /// @param collision The collision's number in its link; becomes the shape's user index.
  /// @return Null where it is not a simple shape: that of triangles, or none.
  std::shared_ptr<btCollisionShape> shape(const description::Geometry& geometry, const description::Surface& surface,
                                          int collision);

  /// How many things are known, some of which nobody may have any more.
  std::size_t size() const { return surfaces_.size() + shapes_.size(); }

 private:
  struct ShapeEntry {
    description::Geometry geometry;
    const description::Surface* surface;
    int collision;
    std::weak_ptr<btCollisionShape> shape;
    bool expired() const { return shape.expired(); }
  };
  /// By hash, in which some may be alike.
  template <class Entry>
  using Table = std::unordered_multimap<std::uint64_t, Entry>;

  Table<std::weak_ptr<const description::Surface>> surfaces_;
  Table<ShapeEntry> shapes_;
  /// How many entries each table may have before those that nobody has are looked for.
  std::size_t mostSurfaces_ = 64;
  std::size_t mostShapes_ = 64;
};

}  // namespace pongsim::physics
