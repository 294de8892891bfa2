#pragma once

#include "rendering/gl.hh"
#include "rendering/program.hh"

namespace pongsim::rendering {

/// Combines the samples of each pixel to their mean. Must not outlive its context.
class Resolve {
 public:
  explicit Resolve(const Gl& gl);
  ~Resolve();
  Resolve(const Resolve&) = delete;
  Resolve& operator=(const Resolve&) = delete;

  /// Fills the framebuffer in use.
  /// @param samples A texture of four samples per pixel.
  void draw(GLuint samples) const;

 private:
  const Gl& gl_;
  Program program_;
  /// An empty vertex array, for geometry made in a shader.
  GLuint nothing_ = 0;
};

}  // namespace pongsim::rendering
