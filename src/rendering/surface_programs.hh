#pragma once

#include <array>
#include <map>
#include <memory>

#include "rendering/gl.hh"
#include "rendering/lighting.hh"
#include "rendering/program.hh"
#include "rendering/scene.hh"

namespace pongsim::rendering {

/// The programs that draw surfaces in colours: one for each kind of surface under each set of lamps, compiled when it
/// is first needed. Must not outlive its context.
class SurfacePrograms {
 public:
  explicit SurfacePrograms(const Gl& gl) : gl_(gl) {}

  /// Selects the lamps and the fog of what is drawn next.
  void setLight(const LightKinds& kinds);

  const Program& of(const Item& item);

 private:
  // whether it is lit, has a colour map, and has other maps
  static constexpr std::size_t kKinds = 8;
  using Programs = std::array<std::unique_ptr<const Program>, kKinds>;

  const Gl& gl_;
  std::map<LightKinds, Programs> programs_;
  /// Those of the lamps in use.
  std::map<LightKinds, Programs>::iterator inUse_ = programs_.end();
};

/// @return Whether it has textures other than its colour.
bool isMapped(const Item& item);

}  // namespace pongsim::rendering
