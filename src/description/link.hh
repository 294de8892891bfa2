#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/added_mass.hh"
#include "description/geometry.hh"
#include "description/heat.hh"
#include "description/light.hh"
#include "description/material.hh"
#include "description/particle_emitter.hh"
#include "description/plugin.hh"
#include "description/sensor.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// `<inertial>`: mass and inertia.
struct Inertial {
  /// [kg]
  double mass = 1;
  /// Pose of the frame of `moments` in the link frame; its origin is the centre of mass.
  Pose X_LinkCom;
  /// Inertia tensor about the centre of mass [kg m^2].
  Matrix3 moments = Matrix3::Identity();
  /// `<fluid_added_mass>`; unset for a static link.
  std::optional<AddedMass> addedMass = std::nullopt;
  bool operator==(const Inertial&) const = default;
};

/// `<torsional>`: friction of a contact patch against spinning about its normal.
struct Torsion {
  double coefficient = 1;
  /// Radius of the patch [m] (`<patch_radius>`).
  double patchRadius = 0;
  /// Radius of curvature of the surface at the contact [m] (`<surface_radius>`): determines the patch, together with
  /// the depth, if `<use_patch_radius>` is false.
  double surfaceRadius = 0;
  bool usesPatchRadius = true;
  /// Spin velocity per newton metre of friction (`<ode><slip>`) [rad/s/(N m)].
  double slip = 0;
  bool operator==(const Torsion&) const = default;
};

/// `<surface>`: contact properties of a collision.
struct Surface {
  /// Friction coefficients along the first and second direction (`<friction><ode><mu>`, `<mu2>`).
  double mu = 1;
  double mu2 = 1;
  /// First friction direction (`<fdir1>`), in the frame of the collision or of a link; zero: chosen by the engine.
  Vector3 fdir1 = Vector3::Zero();
  /// Link of the model in whose frame `fdir1` is given (`<fdir1 ignition:expressed_in>`); empty: the collision frame.
  /// For a mecanum wheel this is the chassis, so that the direction does not turn with the wheel.
  std::string fdir1Link;
  /// Slip velocity along the two directions per newton of friction (`<slip1>`, `<slip2>`) [m/s/N].
  double slip1 = 0;
  double slip2 = 0;
  /// Two collisions can touch if their masks share a bit (`<contact><collide_bitmask>`).
  std::uint16_t collideBitmask = 0xff;
  /// `<bounce><restitution_coefficient>`, 0 to 1.
  double restitution = 0;
  /// Slower impacts [m/s] don't bounce (`<bounce><threshold>`); unset: the engine's default.
  std::optional<double> bounceThreshold;
  /// `<torsional>`: friction against spinning about the normal.
  Torsion torsion;
  /// Maximum number of contact points with another collision (`<max_contacts>`); unset: see the world's `<physics>`.
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
  /// Unset: the mesh's own material, or grey.
  std::optional<Material> material;
  /// 0: opaque, 1: invisible.
  double transparency = 0;
  bool castsShadows = true;
  /// Cameras see it if their visibility mask shares a bit with these.
  std::uint32_t visibilityFlags = 0xFFFFFFFF;
  /// Intensity in lidar scans.
  double laserRetro = 0;
  /// `<meta><layer>`
  long long layer = 0;
  /// For segmentation and bounding-box cameras, from the system `label` in it; unset: that of its model or actor.
  std::optional<std::uint8_t> label;
  /// Unset: as warm as the air around it.
  std::optional<Heat> heat;
  std::vector<Plugin> plugins;
  bool operator==(const Visual&) const = default;
};

/// A `<link>`.
struct Link {
  std::string name;
  SourcePosition position;
  Pose X_ModelLink;
  Inertial inertial;
  std::vector<Collision> collisions;
  std::vector<Visual> visuals;
  std::vector<Sensor> sensors;
  std::vector<Light> lights;
  std::vector<ParticleEmitter> emitters;
  /// `<gravity>`
  bool gravity = true;
  /// `<kinematic>`
  bool kinematic = false;
  /// `<self_collide>`: whether it collides with other links of its model; unset: see the model.
  std::optional<bool> selfCollide;
  /// `<enable_wind>`: whether the wind acts on it; unset: see the model.
  std::optional<bool> isInWind;
  /// `<velocity_decay>`, fraction of the velocity lost per second.
  double linearDamping = 0;
  double angularDamping = 0;
  bool operator==(const Link&) const = default;
};

}  // namespace pongsim::description
