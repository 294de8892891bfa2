#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/geometry.hh"
#include "description/light.hh"
#include "description/material.hh"
#include "description/plugin.hh"
#include "description/sensor.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// `<inertial>`: mass and how it is spread.
struct Inertial {
  /// [kg]
  double mass = 1;
  /// Pose of the frame of `moments` in the link frame; its origin is the centre of mass.
  Pose X_LinkCom;
  /// Inertia tensor about the centre of mass [kg m^2].
  Matrix3 moments = Matrix3::Identity();
  bool operator==(const Inertial&) const = default;
};

/// `<torsional>`: friction of a patch against turning about its normal.
struct Torsion {
  double coefficient = 1;
  /// Of the patch [m] (`<patch_radius>`).
  double patchRadius = 0;
  /// Of the surface where it touches [m] (`<surface_radius>`): makes the patch, with the depth, where
  /// `<use_patch_radius>` is false.
  double surfaceRadius = 0;
  bool usesPatchRadius = true;
  /// How fast it turns by each newton metre of friction (`<ode><slip>`) [rad/s/(N m)].
  double slip = 0;
  bool operator==(const Torsion&) const = default;
};

/// `<surface>`: how a collision's skin behaves.
struct Surface {
  /// Friction coefficient along the first and the second direction (`<friction><ode><mu>`, `<mu2>`).
  double mu = 1;
  double mu2 = 1;
  /// First friction direction (`<fdir1>`), in the collision frame or in that of a link; zero: the engine chooses.
  Vector3 fdir1 = Vector3::Zero();
  /// Link of the model in whose frame `fdir1` is (`<fdir1 ignition:expressed_in>`); empty: the collision frame. Of a
  /// mecanum wheel, that of the chassis: the direction does not turn with the wheel.
  std::string fdir1Link;
  /// How fast it slips along the two directions by each newton of friction (`<slip1>`, `<slip2>`) [m/s/N].
  double slip1 = 0;
  double slip2 = 0;
  /// Two collisions touch where their masks share a bit (`<contact><collide_bitmask>`).
  std::uint16_t collideBitmask = 0xff;
  /// `<bounce><restitution_coefficient>`, 0 to 1.
  double restitution = 0;
  /// Slower than that [m/s] nothing bounces (`<bounce><threshold>`); unset, as the engine has it.
  std::optional<double> bounceThreshold;
  /// Of contacts (`<contact><ode><kp>`, `<kd>`) [N/m], [N s/m]; unset: rigid.
  std::optional<double> stiffness;
  double damping = 1;
  /// `<torsional>`: against turning about the normal.
  Torsion torsion;
  /// Points at which it touches another collision (`<max_contacts>`); unset, as the world's `<physics>` says.
  std::optional<long long> maxContacts;
  bool operator==(const Surface&) const = default;
};

struct Collision {
  std::string name;
  SourcePosition position;
  Pose X_LinkCollision;
  Geometry geometry;
  Surface surface;
  bool operator==(const Collision&) const = default;
};

struct Visual {
  std::string name;
  SourcePosition position;
  Pose X_LinkVisual;
  Geometry geometry;
  /// Without one: as its mesh says, or grey.
  std::optional<Material> material;
  /// 0: not to be seen through, 1: not to be seen.
  double transparency = 0;
  bool castsShadows = true;
  /// A camera sees it where one of these bits is in its visibility mask.
  std::uint32_t visibilityFlags = 0xFFFFFFFF;
  /// Intensity that a lidar sees.
  double laserRetro = 0;
  /// `<meta><layer>`
  long long layer = 0;
  std::vector<Plugin> plugins;
  bool operator==(const Visual&) const = default;
};

/// What a `<link>` says.
struct Link {
  std::string name;
  SourcePosition position;
  Pose X_ModelLink;
  Inertial inertial;
  std::vector<Collision> collisions;
  std::vector<Visual> visuals;
  std::vector<Sensor> sensors;
  std::vector<Light> lights;
  /// `<gravity>`
  bool gravity = true;
  /// `<kinematic>`
  bool kinematic = false;
  /// `<self_collide>`: collides with other links of its model; unset, as the model says.
  std::optional<bool> selfCollide;
  /// `<enable_wind>`: the wind moves it; unset, as the model says.
  std::optional<bool> isInWind;
  /// `<velocity_decay>`, fraction of the velocity lost a second.
  double linearDamping = 0;
  double angularDamping = 0;
  bool operator==(const Link&) const = default;
};

}  // namespace pongsim::description
