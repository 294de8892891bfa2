#pragma once

#include <filesystem>

namespace pongsim::physics {

/// How Bullet solves joints and contacts together.
enum class Solver {
  /// Dantzig's direct method for small groups of bodies, iterations for large ones.
  kDirect,
  /// Projected Gauss-Seidel.
  kSequentialImpulse,
  /// The same, sped up by non-smooth conjugate gradients.
  kNncg,
};

/// Penetration is taken back no faster than by that times the length of a step [m/s^2]: at about the speed that gravity
/// gives in a step, which is what the solver's own errors are of. Fortress's engine takes all back at 1 mm/s.
inline constexpr double kFastestParting = 10;

/// How the step is computed. The defaults are what the measurements in `docs/physics.md` speak for.
struct Settings {
  /// How many threads solve groups of bodies; the result is the same.
  int threads = 1;
  Solver solver = Solver::kDirect;
  /// At most, where there are iterations.
  int iterations = 50;
  /// Iterations end earlier once no row's impulse changes by more than the square root of that; 0 never.
  double residual = 0;
  /// Groups of bodies with more rows of joints and contacts than that are not solved directly.
  int mostDirectRows = 150;
  /// Softness of all rows [1/(N m s) and the like]: lets the direct method solve a box on four corners, too.
  double softness = 1e-8;
  /// Parts of an error that a step takes back, in joints and in contacts.
  double jointErrorReduction = 0.9;
  double contactErrorReduction = 0.2;
  /// Points at which two collisions touch, where neither says how many; negative: no limit. Bullet has four at most.
  long long maxContacts = 20;
  /// Where pieces of meshes are kept for later runs; empty: nowhere.
  std::filesystem::path hullCache = {};
};

}  // namespace pongsim::physics
