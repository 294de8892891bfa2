#include "rendering/values.hh"

#include <algorithm>
#include <cmath>

#include "rendering/shaders.hh"

namespace pongsim::rendering {

namespace {

// locations of the uniforms below
constexpr int kNumber = 13;
constexpr int kWeights = 14;
constexpr int kRange = 15;

constexpr const char* kNumberFragment = R"(#version 450 core
layout(location = 13) uniform float number;
out float value;
void main() { value = number; }
)";

constexpr const char* kTemperatureFragment = R"(#version 450 core
layout(location = 14) uniform vec4 weights;  // of red, green and blue; w: whether there is a picture
layout(location = 15) uniform vec3 range;    // temperatures at brightness 0 and 1
layout(binding = 0) uniform sampler2D picture;
in vec2 texel;
out float value;
void main() {
  vec3 color = weights.w > 0.0 ? texture(picture, texel).rgb : vec3(1);
  value = mix(range.x, range.y, dot(weights.rgb, color));
}
)";

// temperatures above are drawn like this, because infinite ones could not be mixed [K]
constexpr double kHottest = 1e9;

/// Brightness of a colour (ITU-R BT.601).
const Eigen::Vector3f kBrightness{0.299F, 0.587F, 0.114F};

}  // namespace

DepthPass::DepthPass(const Gl& gl) : gl_(gl), program_(gl, shaders::kSurfaceVertex, shaders::kDepthFragment) {}

void DepthPass::use() const {
  program_.use();
  const Eigen::Vector3f ahead = ahead_.cast<float>();
  gl_.uniform3fv(shaders::kAhead, 1, ahead.data());
}

NumberPass::NumberPass(const Gl& gl) : gl_(gl), program_(gl, shaders::kSurfaceVertex, kNumberFragment) {}

void NumberPass::set(const Item& item, Store&) const { gl_.uniform1f(kNumber, static_cast<float>(item.number + 1)); }

AirTemperatures airTemperatures(const description::Atmosphere& atmosphere, const PictureView& view) {
  const double quotient = std::max(view.width / view.height, 1U);
  const double height = view.width / (view.fx * quotient) * view.far;
  const double range = std::abs(atmosphere.temperatureGradient * height);
  if (!std::isfinite(range)) return {atmosphere.temperature, atmosphere.temperature};
  return {atmosphere.temperature - range / 2, atmosphere.temperature + range / 2};
}

TemperaturePass::TemperaturePass(const Gl& gl) : gl_(gl), program_(gl, shaders::kSurfaceVertex, kTemperatureFragment) {}

void TemperaturePass::set(const Item& item, Store& store) const {
  const std::optional<Warmth>& warmth = item.warmth;
  const auto& picture = warmth ? warmth->signature : item.pictures[kColorMap];
  // a signature tells temperatures in red
  const Eigen::Vector3f weights =
      warmth ? Eigen::Vector3f::UnitX().eval() : kBrightness.cwiseProduct(item.paint.diffuse).eval();
  const double coldest = warmth ? warmth->coldest : air_.coldest;
  const double hottest = !warmth ? air_.hottest : picture != nullptr ? warmth->hottest : coldest;
  if (picture != nullptr) store.use(0, picture, !warmth);
  const Eigen::Vector4f all(weights.x(), weights.y(), weights.z(), picture != nullptr ? 1.0F : 0.0F);
  gl_.uniform4fv(kWeights, 1, all.data());
  const Eigen::Vector3f range(static_cast<float>(std::min(coldest, kHottest)),
                              static_cast<float>(std::min(hottest, kHottest)), 0);
  gl_.uniform3fv(kRange, 1, range.data());
}

}  // namespace pongsim::rendering
