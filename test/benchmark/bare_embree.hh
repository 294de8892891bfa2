#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "description/world.hh"
#include "pongsim/sensing/camera_scene.hh"
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

  /// Draws a picture of matt surfaces: one ray for each pixel, four where it differs from its neighbours, and one to
  /// the light from each hit, in packets of eight.
  /// @param light Unit vector towards it.
  /// @param pixels Red, green, blue, row by row.
  void draw(const PictureView& view, const Vector3& light, std::span<std::uint8_t> pixels) const;

 private:
  struct Scene;
  struct Packet;
  void trace(const PictureView& view, const Vector3& light, Packet& packet) const;

  std::unique_ptr<Scene> scene_;
  std::size_t size_ = 0;
  /// Of each visual.
  std::vector<Eigen::Vector3f> colors_;
};

}  // namespace pongsim::benchmark
