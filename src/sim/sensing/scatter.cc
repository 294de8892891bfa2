#include "sim/sensing/scatter.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace pongsim::sim {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// The foremost particle in a direction.
struct Foremost {
  double distance = kNowhere;
  std::size_t cloud = 0;
};

}  // namespace

Scatter::Scatter(Access& access, std::string_view sensor)
    : draws_(Random(access.particlesNow().seed(), "scatter of " + std::string(sensor))
                 .at(static_cast<std::uint64_t>(access.state.time.count()))) {
  for (const world::Emitter& emitter : access.particles.emitters()) {
    if (emitter.particles.empty() || access.entities.slot(emitter.link) == world::kNoSlot) continue;
    Cloud cloud;
    double least = kNowhere, most = -kNowhere;
    for (const world::Particle& particle : emitter.particles) {
      const world::PlacedParticle placed = world::placed(emitter, particle, access.state.time);
      if (placed.width <= 0 || placed.height <= 0) continue;
      cloud.discs.push_back({placed.place, placed.width / 2, placed.height / 2});
      const double reach = std::max(placed.width, placed.height) / 2;
      least = std::min(least, placed.place.x() - reach);
      most = std::max(most, placed.place.x() + reach);
    }
    if (cloud.discs.empty()) continue;
    cloud.ratio = emitter.now.scatterRatio;
    cloud.deviation = (most - least) / 4;
    clouds_.push_back(std::move(cloud));
  }
}

double Scatter::scattered(const Cloud& cloud, double range, double behind) {
  if (draws_.uniform() >= cloud.ratio) return behind;
  const double off = draws_.uniform() - 0.5;
  const double noise = draws_.normal(off * off * cloud.deviation / 2, cloud.deviation);
  const double further = range + std::sqrt(3.0) * std::abs(noise);
  return further < behind ? further : behind;
}

void Scatter::apply(const PictureView& view, std::span<float> depths) {
  std::vector<Foremost> foremost(depths.size());
  const Pose X_EyeWorld = view.X_WorldEye.inverse();
  const auto bounded = [](double pixel, std::uint32_t size) {
    return static_cast<std::uint32_t>(std::clamp(pixel, 0.0, static_cast<double>(size)));
  };
  for (std::size_t number = 0; number < clouds_.size(); ++number) {
    for (const Disc& disc : clouds_[number].discs) {
      const Vector3 place = X_EyeWorld * disc.place;
      if (place.x() <= view.near || place.x() >= view.far) continue;
      const double halfU = view.fx * disc.halfWidth / place.x(), halfV = view.fy * disc.halfHeight / place.x();
      const double u = view.cx - (view.fx * place.y() + view.skew * place.z()) / place.x();
      const double v = view.cy - view.fy * place.z() / place.x();
      const std::uint32_t top = bounded(v - halfV, view.height), bottom = bounded(v + halfV + 1, view.height);
      const std::uint32_t left = bounded(u - halfU, view.width), right = bounded(u + halfU + 1, view.width);
      for (std::uint32_t row = top; row < bottom; ++row) {
        const double down = (row + 0.5 - v) / halfV;
        for (std::uint32_t column = left; column < right; ++column) {
          const double across = (column + 0.5 - u) / halfU;
          Foremost& here = foremost[std::size_t{row} * view.width + column];
          if (across * across + down * down > 1 || here.distance <= place.x()) continue;
          here = {place.x(), number};
        }
      }
    }
  }
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto behind = static_cast<double>(depths[i]);
    if (foremost[i].distance >= behind) continue;
    const double v = (static_cast<double>(i / view.width) + 0.5 - view.cy) / view.fy;
    const double u = (static_cast<double>(i % view.width) + 0.5 - view.cx - view.skew * v) / view.fx;
    // of the ranges along the beam, as Fortress adds to them
    const double slant = std::sqrt(1 + u * u + v * v);
    const double depth = scattered(clouds_[foremost[i].cloud], foremost[i].distance * slant, behind * slant) / slant;
    depths[i] = depth < view.far ? static_cast<float>(depth) : std::numeric_limits<float>::infinity();
  }
}

void Scatter::apply(const Pose& X_WorldSensor, std::span<const Vector3> directions, double minRange, double maxRange,
                    std::span<Echo> echoes) {
  std::vector<Foremost> foremost(directions.size());
  const Pose X_SensorWorld = X_WorldSensor.inverse();
  for (std::size_t number = 0; number < clouds_.size(); ++number) {
    for (const Disc& disc : clouds_[number].discs) {
      const Vector3 place = X_SensorWorld * disc.place;
      const double distance = place.norm();
      if (distance <= 0 || distance > maxRange + std::max(disc.halfWidth, disc.halfHeight)) continue;
      const Vector3 ahead = place / distance;
      const Vector3 left = Vector3::UnitZ().cross(ahead).stableNormalized(), up = ahead.cross(left);
      const double reach = std::max(disc.halfWidth, disc.halfHeight);
      const double leastCosine = distance / std::sqrt(distance * distance + reach * reach);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const double cosine = directions[i].dot(ahead);
        if (cosine < leastCosine) continue;
        const double range = distance / cosine;
        if (range < minRange || range > maxRange || range >= foremost[i].distance) continue;
        const double across = range * directions[i].dot(left) / disc.halfWidth;
        const double along = range * directions[i].dot(up) / disc.halfHeight;
        if (across * across + along * along <= 1) foremost[i] = {range, number};
      }
    }
  }
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    Echo& echo = echoes[i];
    // of what is hit too near, nothing is known
    if (foremost[i].distance >= echo.range || std::isinf(foremost[i].distance)) continue;
    const double range = scattered(clouds_[foremost[i].cloud], foremost[i].distance, echo.range);
    if (range == echo.range) continue;
    echo = {range <= maxRange ? range : kNowhere, 0};
  }
}

}  // namespace pongsim::sim
