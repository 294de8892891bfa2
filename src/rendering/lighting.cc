#include "rendering/lighting.hh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace pongsim::rendering {

namespace {

using description::Light;
using description::LightType;
using Eigen::Matrix4d;
using Eigen::Vector4f;

// in larger scenes, shadows are only drawn within this distance from the camera [m]
constexpr double kMostShadowRadius = 25;
constexpr double kNearestShade = 0.05;
constexpr double kFarthestShade = 1000;
// of the clouds [m], and their least size in heights
constexpr double kCloudHeight = 100, kSmallestCloud = 0.01;

/// A sphere that contains all visible shadows. In the world frame.
struct Region {
  Vector3 middle = Vector3::Zero();
  double radius = 1;
  /// Bounding box of everything that casts shadows.
  Eigen::AlignedBox3d casters = {};
};

std::optional<Region> shadowRegion(const Scene& scene, const PictureView& view) {
  Region region;
  for (const Item& item : scene.items()) {
    if (item.castsShadows && !item.isGround) region.casters.extend(item.boundsInWorld());
  }
  if (region.casters.isEmpty()) return std::nullopt;
  region.middle = region.casters.center();
  region.radius = region.casters.diagonal().norm() / 2;
  if (region.radius > kMostShadowRadius) {
    region.radius = kMostShadowRadius;
    region.middle = view.X_WorldEye * Vector3(0.8 * kMostShadowRadius, 0, 0);
  }
  return region;
}

/// @return Axes whose last one points against a direction.
Matrix3 axesAgainst(const Vector3& direction) {
  const Vector3 z = -direction;
  const Vector3 x = (std::abs(z.z()) < 0.9 ? Vector3::UnitZ() : Vector3::UnitX()).cross(z).normalized();
  Matrix3 axes;
  axes.row(0) = x;
  axes.row(1) = z.cross(x);
  axes.row(2) = z;
  return axes;
}

/// Directional light: a box along the light's direction, extended to objects in front of the region that cast shadows
/// into it.
Shadow parallelShadow(const Region& region, const Vector3& direction) {
  const Matrix3 axes = axesAgainst(direction);
  double top = region.radius;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 point = region.casters.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    top = std::max(top, axes.row(2).dot(point - region.middle));
  }
  const double bottom = -region.radius;
  Matrix4d clip = Matrix4d::Identity();
  clip.block<2, 3>(0, 0) = axes.topRows<2>() / region.radius;
  // depths from 0, next to the light, to 1
  clip.block<1, 3>(2, 0) = -1 / (top - bottom) * axes.row(2);
  clip(2, 3) = top / (top - bottom);
  return {region.middle, clip};
}

/// Half the angle covered by a spot light's shadow map [rad].
double halfAngle(const Light& light) { return std::clamp(light.outerAngle / 2 * 1.05, 0.01, 1.4); }

Shadow spotShadow(const Light& light, const Vector3& place, const Vector3& direction) {
  const Matrix3 axes = axesAgainst(direction);
  const double far = std::clamp(light.range, 2 * kNearestShade, kFarthestShade), near = kNearestShade;
  const double scale = 1 / std::tan(halfAngle(light));
  Matrix4d clip = Matrix4d::Zero();
  clip.block<2, 3>(0, 0) = axes.topRows<2>() * scale;
  clip.block<1, 3>(2, 0) = -far / (far - near) * axes.row(2);
  clip.block<1, 3>(3, 0) = -axes.row(2);
  clip(2, 3) = -far * near / (far - near);
  return {place, clip};
}

Vector4f colorOf(const description::Color& color, double intensity, double fourth) {
  const auto factor = static_cast<float>(intensity);
  return {color.red * factor, color.green * factor, color.blue * factor, static_cast<float>(fourth)};
}

float linear(float shown) { return shown <= 0.04045F ? shown / 12.92F : std::pow((shown + 0.055F) / 1.055F, 2.4F); }

void addFog(const description::Fog& fog, Lighting& lighting) {
  const Eigen::Vector3f color = lightOf(fog.color);
  lighting.kinds.fog = fog.type;
  lighting.block.fog = {color.x(), color.y(), color.z(), static_cast<float>(std::max(fog.density, 0.0))};
  const double length = std::max(fog.end - fog.start, 1e-6);
  lighting.block.fogPlace = {static_cast<float>(fog.start), static_cast<float>(1 / length), 0, 0};
}

void addLamp(const Lamp& lamp, const PictureView& view, const std::optional<Region>& region, int shadowEdge,
             LampBlock::Lamp& to, Lighting& lighting) {
  const Light& light = lamp.light;
  const Vector3& eye = view.X_WorldEye.position;
  const Vector3 place = lamp.X_WorldLight.position - eye;
  const Vector3 direction = lamp.X_WorldLight.rotation * light.direction;
  LampKind kind{light.type != LightType::kDirectional, light.type == LightType::kSpot};
  double pixel = 0;
  if (light.castsShadows && region && (!kind.hasPlace || kind.isSpot) &&
      lighting.shadows.size() < shaders::kMostShadows) {
    kind.shadow = static_cast<int>(lighting.shadows.size());
    pixel = 2 * (kind.isSpot ? std::tan(halfAngle(light)) : region->radius) / shadowEdge;
    const Shadow shadow =
        kind.isSpot ? spotShadow(light, lamp.X_WorldLight.position, direction) : parallelShadow(*region, direction);
    Matrix4d clipFromPlace = shadow.clip;
    clipFromPlace.col(3) += shadow.clip.leftCols<3>() * (eye - shadow.origin);
    lighting.block.shadowFromPlace[lighting.shadows.size()] = clipFromPlace.cast<float>();
    lighting.shadows.push_back(shadow);
  }
  lighting.kinds.lamps.push_back(kind);
  const auto four = [](double x, double y, double z, double w) -> Vector4f {
    return Eigen::Vector4d(x, y, z, w).cast<float>();
  };
  to.place = four(place.x(), place.y(), place.z(), 0);
  to.direction = four(direction.x(), direction.y(), direction.z(), 0);
  to.diffuse = colorOf(light.diffuse, light.intensity, 0);
  to.specular = colorOf(light.specular, light.intensity, light.range);
  to.attenuation = four(light.constantAttenuation, light.linearAttenuation, light.quadraticAttenuation, light.falloff);
  to.cone = four(std::cos(light.innerAngle / 2), std::cos(light.outerAngle / 2), pixel, 0);
}

}  // namespace

Lighting lightingOf(const Scene& scene, const PictureView& view, int shadowEdge) {
  Lighting lighting{};
  const description::Scene& surroundings = scene.surroundings();
  const std::optional<Region> region = surroundings.hasShadows ? shadowRegion(scene, view) : std::nullopt;
  const std::size_t count = std::min(scene.lamps().size(), lighting.block.lamps.size());
  for (std::size_t i = 0; i < count; ++i) {
    addLamp(scene.lamps()[i], view, region, shadowEdge, lighting.block.lamps[i], lighting);
  }
  // as in Fortress, whose renderer divides by pi when it spreads ambient light over the hemisphere
  lighting.block.surroundings = colorOf(surroundings.ambient, 1 / std::numbers::pi, 0);
  const Eigen::Vector3f background =
      surroundings.sky ? skyColors(*surroundings.sky).horizon : lightOf(surroundings.background);
  lighting.block.background = {background.x(), background.y(), background.z(), 1};
  if (surroundings.fog) addFog(*surroundings.fog, lighting);
  return lighting;
}

Eigen::Vector3f lightOf(const description::Color& color) {
  return {linear(color.red), linear(color.green), linear(color.blue)};
}

SkyColors skyColors(const description::Sky& sky) {
  const Eigen::Vector3f zenith(0.09F, 0.24F, 0.60F), horizon(0.55F, 0.70F, 0.85F);
  const double length = sky.sunset - sky.sunrise;
  const double sun = length > 0 ? std::sin(std::numbers::pi * (sky.time - sky.sunrise) / length) : 1;
  // bright all day, dark from about an hour after sunset
  const auto daylight = static_cast<float>(std::clamp(0.5 + 3 * sun, 0.05, 1.0));
  return {zenith * daylight, horizon * daylight, lightOf(sky.cloudAmbient) * daylight};
}

Eigen::Vector4f cloudsOf(const description::Sky& sky, Time time) {
  const double way = sky.cloudSpeed * toSeconds(time) / kCloudHeight;
  const Eigen::Vector4d clouds(way * std::cos(sky.cloudDirection), way * std::sin(sky.cloudDirection),
                               1 / std::max(sky.cloudSize, kSmallestCloud), std::clamp(sky.humidity, 0.0, 1.0));
  return clouds.cast<float>();
}

}  // namespace pongsim::rendering
