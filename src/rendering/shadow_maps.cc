#include "rendering/shadow_maps.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "rendering/shaders.hh"

namespace pongsim::rendering {

namespace {

using Eigen::AlignedBox2i;
using Eigen::Vector2i;

/// @return From a surface to positions relative to a shadow's origin.
Eigen::Matrix4f casterPlace(const Item& item, const Vector3& origin) {
  const Pose X_WorldSurface = item.X_WorldSurface();
  Eigen::Matrix4d place = Eigen::Matrix4d::Identity();
  place.topLeftCorner<3, 3>() = X_WorldSurface.rotation.toRotationMatrix() * item.scale.asDiagonal();
  place.topRightCorner<3, 1>() = X_WorldSurface.position - origin;
  return place.cast<float>();
}

}  // namespace

ShadowMaps::ShadowMaps(const Gl& gl, int edge)
    : gl_(gl), edge_(edge), program_(gl, shaders::kSurfaceVertex, shaders::kShadowFragment) {
  gl_.genFramebuffers(1, &frame_);
  gl_.genTextures(1, &textures_);
  gl_.activeTexture(GL_TEXTURE1);
  gl_.bindTexture(GL_TEXTURE_2D_ARRAY, textures_);
  gl_.texImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, edge, edge, shaders::kMostShadows, 0,
                 GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

ShadowMaps::~ShadowMaps() {
  gl_.deleteFramebuffers(1, &frame_);
  gl_.deleteTextures(1, &textures_);
}

void ShadowMaps::draw(const Scene& scene, const std::vector<Shadow>& shadows, Store& store) {
  assert(shadows.size() <= shaders::kMostShadows);
  gl_.activeTexture(GL_TEXTURE1);
  gl_.bindTexture(GL_TEXTURE_2D_ARRAY, textures_);
  maps_.resize(std::max(maps_.size(), shadows.size()));
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    Map map{shadows[i], castersOf(scene, shadows[i])};
    const AlignedBox2i part = changedPart(maps_[i], map);
    if (!part.isEmpty()) draw(i, map, part, store);
    maps_[i] = std::move(map);
  }
}

std::vector<ShadowMaps::Caster> ShadowMaps::castersOf(const Scene& scene, const Shadow& shadow) const {
  std::vector<Caster> casters;
  for (const Item& item : scene.items()) {
    if (!item.castsShadows || item.isGround || item.paint.opacity < 1) continue;
    const AlignedBox2i box = boxOf(item.boundsInWorld(), shadow);
    if (!box.isEmpty()) casters.push_back({item.surface, casterPlace(item, shadow.origin), box});
  }
  return casters;
}

AlignedBox2i ShadowMaps::boxOf(const Eigen::AlignedBox3d& bounds, const Shadow& shadow) const {
  const AlignedBox2i all(Vector2i::Zero(), Vector2i::Constant(edge_ - 1));
  Eigen::AlignedBox2d box;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 point = bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - shadow.origin;
    const Eigen::Vector4d at = shadow.clip * point.homogeneous();
    // behind a spot
    if (!(at.w() > 0)) return all;
    box.extend(Eigen::Vector2d(at.head<2>() / at.w()));
  }
  // with a pixel more at each side, for rounding
  const auto pixel = [this](double clip) {
    return static_cast<int>(std::floor(std::clamp((clip + 1) / 2 * edge_, -2.0, edge_ + 2.0)));
  };
  const AlignedBox2i pixels(Vector2i(pixel(box.min().x()) - 1, pixel(box.min().y()) - 1),
                            Vector2i(pixel(box.max().x()) + 1, pixel(box.max().y()) + 1));
  return pixels.intersection(all);
}

AlignedBox2i ShadowMaps::changedPart(const Map& from, const Map& to) const {
  const AlignedBox2i all(Vector2i::Zero(), Vector2i::Constant(edge_ - 1));
  if (from.shadow != to.shadow || from.casters.size() != to.casters.size()) return all;
  AlignedBox2i part;
  for (std::size_t i = 0; i < to.casters.size(); ++i) {
    if (from.casters[i] == to.casters[i]) continue;
    part.extend(from.casters[i].box);
    part.extend(to.casters[i].box);
  }
  return part;
}

void ShadowMaps::draw(std::size_t number, const Map& map, const AlignedBox2i& part, Store& store) {
  gl_.bindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.framebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, textures_, 0, static_cast<GLint>(number));
  gl_.drawBuffer(GL_NONE);
  gl_.readBuffer(GL_NONE);
  gl_.viewport(0, 0, edge_, edge_);
  gl_.enable(GL_DEPTH_TEST);
  gl_.depthFunc(GL_LESS);
  gl_.depthMask(GL_TRUE);
  gl_.disable(GL_BLEND);
  // both sides cast shadows
  gl_.disable(GL_CULL_FACE);
  const Vector2i size = part.sizes() + Vector2i::Ones();
  const bool isWhole = size.minCoeff() == edge_;
  if (!isWhole) {
    gl_.enable(GL_SCISSOR_TEST);
    gl_.scissor(part.min().x(), part.min().y(), size.x(), size.y());
  }
  constexpr float kFar = 1;
  gl_.clearBufferfv(GL_DEPTH, 0, &kFar);
  program_.use();
  gl_.uniformMatrix4fv(shaders::kClipFromPlace, 1, GL_FALSE, Eigen::Matrix4f(map.shadow.clip.cast<float>()).data());
  for (const Caster& caster : map.casters) {
    if (!caster.box.intersects(part)) continue;
    gl_.uniformMatrix4fv(shaders::kPlaceFromSurface, 1, GL_FALSE, caster.place.data());
    store.draw(caster.surface);
  }
  gl_.disable(GL_SCISSOR_TEST);
}

}  // namespace pongsim::rendering
