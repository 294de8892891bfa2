#pragma once

#include "rendering/gl.hh"
#include "rendering/program.hh"

namespace pongsim::rendering {

/// Shadow maps: images of the distances from the lights. Must not outlive its context.
class ShadowMaps {
 public:
  explicit ShadowMaps(const Gl& gl);
  ~ShadowMaps();
  ShadowMaps(const ShadowMaps&) = delete;
  ShadowMaps& operator=(const ShadowMaps&) = delete;

  /// @param edge Edge length of the maps that follow [pixels].
  void begin(int edge);
  /// Clears a map, and makes it the target of the drawing that follows.
  void use(int number);

 private:
  const Gl& gl_;
  Program program_;
  GLuint frame_ = 0;
  GLuint textures_ = 0;
  int edge_ = 0;
};

}  // namespace pongsim::rendering
