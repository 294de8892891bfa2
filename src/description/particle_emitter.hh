#pragma once

#include <optional>
#include <string>

#include "description/color.hh"
#include "description/material.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// `<particle_emitter>`: emits particles such as those of smoke along the x axis of its frame.
struct ParticleEmitter {
  /// Where particles begin.
  enum class Type { kPoint, kBox, kCylinder, kEllipsoid };
  std::string name;
  SourcePosition position;
  Pose X_LinkEmitter;
  Type type = Type::kPoint;
  /// Of the volume in which particles begin [m]. As in Fortress, whose renderer counts from the direction of emission,
  /// the first is along y, the second along z and the third along x.
  Vector3 size = Vector3::Ones();
  /// [1/s]
  double rate = 10;
  /// [s]; 0 or less: for ever.
  double duration = 0;
  bool isEmitting = true;
  /// Width and height at first [m]; the third has no effect.
  Vector3 particleSize = Vector3::Ones();
  /// [s]
  double lifetime = 5;
  /// [m/s]
  double minVelocity = 1;
  double maxVelocity = 1;
  Color colorStart{1, 1, 1, 1};
  Color colorEnd{1, 1, 1, 1};
  /// What is added to width and height [m/s].
  double scaleRate = 0;
  /// An image whose colours from left to right replace the two above.
  Texture colorRange;
  /// `<topic>`; empty: not given.
  std::string topic;
  /// Share of the beams that particles reflect, 0 to 1.
  double scatterRatio = 0.65;
  std::optional<Material> material;
  bool operator==(const ParticleEmitter&) const = default;
};

/// @return What is wrong with its numbers, such as "its <rate> is below zero"; empty: nothing.
std::string faultOf(const ParticleEmitter& emitter);

}  // namespace pongsim::description
