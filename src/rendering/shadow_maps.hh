#pragma once

#include "rendering/gl.hh"
#include "rendering/program.hh"

namespace pongsim::rendering {

/// Pictures of how far the light of lamps gets, which shadows are made with. It lives while its context does.
class ShadowMaps {
 public:
  explicit ShadowMaps(const Gl& gl);
  ~ShadowMaps();
  ShadowMaps(const ShadowMaps&) = delete;
  ShadowMaps& operator=(const ShadowMaps&) = delete;

  /// @param edge Of the pictures that follow [pixels].
  void begin(int edge);
  /// Empties a picture, and lets what follows be drawn into it.
  void use(int number);

 private:
  const Gl& gl_;
  Program program_;
  GLuint frame_ = 0;
  GLuint textures_ = 0;
  int edge_ = 0;
};

}  // namespace pongsim::rendering
