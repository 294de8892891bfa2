#pragma once

#include <string>

#include "pongsim/types.hh"

namespace pongsim::description {

/// `<physics><ode>`
struct OdeSettings {
  std::string solver = "quick";
  /// [s]
  double minStepSize = 0.0001;
  long long islandThreads = 0;
  long long iterations = 50;
  long long preconditionIterations = 0;
  /// Successive over-relaxation.
  double sor = 1.3;
  bool threadsPositionCorrection = false;
  bool rescalesInertia = false;
  std::string frictionModel = "pyramid_model";
  /// Constraint force mixing, error reduction.
  double cfm = 0;
  double erp = 0.2;
  /// [m/s]
  double contactMaxCorrectingVelocity = 100;
  /// [m]
  double contactSurfaceLayer = 0.001;
  bool operator==(const OdeSettings&) const = default;
};

/// `<physics><bullet>`
struct BulletSettings {
  std::string solver = "sequential_impulse";
  /// [s]
  double minStepSize = 0.0001;
  long long iterations = 50;
  double sor = 1.3;
  double cfm = 0;
  double erp = 0.2;
  /// [m]
  double contactSurfaceLayer = 0.001;
  bool splitsImpulse = true;
  /// [m]
  double splitImpulsePenetrationThreshold = -0.01;
  bool operator==(const BulletSettings&) const = default;
};

/// `<physics><simbody>`
struct SimbodySettings {
  /// [s]
  double minStepSize = 0.0001;
  /// Relative.
  double accuracy = 1e-3;
  /// [m/s]
  double maxTransientVelocity = 0.01;
  /// [N/m]
  double stiffness = 1e8;
  /// [s/m]
  double dissipation = 100;
  double plasticRestitution = 0.5;
  /// [m/s]
  double plasticImpactVelocity = 0.5;
  double staticFriction = 0.9;
  double dynamicFriction = 0.9;
  /// [s/m]
  double viscousFriction = 0;
  /// [m/s]
  double impactCaptureVelocity = 0.001;
  /// [m/s]
  double stictionTransitionVelocity = 0.001;
  bool operator==(const SimbodySettings&) const = default;
};

/// `<physics><dart>`
struct DartSettings {
  std::string solver = "dantzig";
  std::string collisionDetector = "fcl";
  bool operator==(const DartSettings&) const = default;
};

/// A `<physics>` profile. Settings for other engines are kept for programs that ask for them.
struct PhysicsProfile {
  std::string name = "default_physics";
  /// The engine that it is meant for: "ode".
  std::string type = "ode";
  bool isDefault = false;
  Time maxStepSize = std::chrono::milliseconds(1);
  /// Simulated seconds per second of wall time; 0: as many as possible.
  double realTimeFactor = 1;
  /// Steps per second [1/s].
  double realTimeUpdateRate = 1000;
  /// Contact points between two bodies.
  long long maxContacts = 20;
  OdeSettings ode;
  BulletSettings bullet;
  SimbodySettings simbody;
  DartSettings dart;
  bool operator==(const PhysicsProfile&) const = default;
};

}  // namespace pongsim::description
