#include "rendering/resolve.hh"

#include "rendering/shaders.hh"

namespace pongsim::rendering {

Resolve::Resolve(const Gl& gl) : gl_(gl), program_(gl, shaders::kResolveVertex, shaders::kResolveFragment) {
  gl_.genVertexArrays(1, &nothing_);
}

Resolve::~Resolve() { gl_.deleteVertexArrays(1, &nothing_); }

void Resolve::draw(GLuint samples) const {
  gl_.disable(GL_DEPTH_TEST);
  gl_.disable(GL_CULL_FACE);
  gl_.disable(GL_BLEND);
  gl_.activeTexture(GL_TEXTURE0);
  gl_.bindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples);
  program_.use();
  gl_.bindVertexArray(nothing_);
  gl_.drawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pongsim::rendering
