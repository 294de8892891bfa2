#include "rendering/shadow_maps.hh"

#include <cassert>

#include "rendering/shaders.hh"

namespace pongsim::rendering {

ShadowMaps::ShadowMaps(const Gl& gl) : gl_(gl), program_(gl, shaders::kSurfaceVertex, shaders::kShadowFragment) {
  gl_.genFramebuffers(1, &frame_);
  gl_.genTextures(1, &textures_);
  begin(1);
}

ShadowMaps::~ShadowMaps() {
  gl_.deleteFramebuffers(1, &frame_);
  gl_.deleteTextures(1, &textures_);
}

void ShadowMaps::begin(int edge) {
  gl_.activeTexture(GL_TEXTURE1);
  gl_.bindTexture(GL_TEXTURE_2D_ARRAY, textures_);
  if (edge == edge_) return;
  edge_ = edge;
  gl_.texImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, edge, edge, shaders::kMostShadows, 0,
                 GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void ShadowMaps::use(int number) {
  assert(number >= 0 && number < shaders::kMostShadows);
  gl_.bindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.framebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, textures_, 0, number);
  gl_.drawBuffer(GL_NONE);
  gl_.readBuffer(GL_NONE);
  gl_.viewport(0, 0, edge_, edge_);
  gl_.enable(GL_DEPTH_TEST);
  gl_.depthFunc(GL_LESS);
  gl_.depthMask(GL_TRUE);
  gl_.disable(GL_BLEND);
  constexpr float kFar = 1;
  gl_.clearBufferfv(GL_DEPTH, 0, &kFar);
  program_.use();
}

}  // namespace pongsim::rendering
