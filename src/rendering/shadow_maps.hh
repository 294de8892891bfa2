#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pongsim/types.hh"
#include "rendering/gl.hh"
#include "rendering/lighting.hh"
#include "rendering/program.hh"
#include "rendering/scene.hh"
#include "rendering/store.hh"

namespace pongsim::rendering {

/// Depth maps seen from lights. They are kept from picture to picture: only where something has moved they are drawn
/// again. What they show does not depend on which pictures were drawn before. Must not outlive its context.
class ShadowMaps {
 public:
  /// @param edge Edge length [pixels].
  ShadowMaps(const Gl& gl, int edge);
  ~ShadowMaps();
  ShadowMaps(const ShadowMaps&) = delete;
  ShadowMaps& operator=(const ShadowMaps&) = delete;

  /// Draws the maps and binds them to texture unit 1.
  void draw(const Scene& scene, const std::vector<Shadow>& shadows, Store& store);

 private:
  /// Something that casts shadows, placed.
  struct Caster {
    std::shared_ptr<const Surface> surface;
    /// From the surface to positions relative to the shadow's origin.
    Eigen::Matrix4f place;
    /// The part of the map that it may cover [pixels].
    Eigen::AlignedBox2i box;

    bool operator==(const Caster& other) const { return surface == other.surface && place == other.place; }
  };
  /// What a map shows.
  struct Map {
    Shadow shadow;
    std::vector<Caster> casters;
  };

  std::vector<Caster> castersOf(const Scene& scene, const Shadow& shadow) const;
  Eigen::AlignedBox2i boxOf(const Eigen::AlignedBox3d& bounds, const Shadow& shadow) const;
  /// @return The part of a map that must be drawn again.
  Eigen::AlignedBox2i changedPart(const Map& from, const Map& to) const;
  void draw(std::size_t number, const Map& map, const Eigen::AlignedBox2i& part, Store& store);

  const Gl& gl_;
  int edge_;
  Program program_;
  GLuint frame_ = 0;
  GLuint textures_ = 0;
  std::vector<Map> maps_;
};

}  // namespace pongsim::rendering
