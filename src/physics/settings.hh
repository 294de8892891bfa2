#pragma once

#include <filesystem>

namespace pongsim::physics {

/// How joints and contacts are solved.
enum class Solver {
  /// Dantzig's direct method for small groups of bodies, iterations for large ones.
  kDirect,
  /// Projected Gauss-Seidel.
  kSequentialImpulse,
};

/// Penetration is corrected at most at this times the step size [m/s^2], about the speed that gravity gives in a step,
/// which is the magnitude of the solver's own errors. Fortress's engine corrects all at 1 mm/s.
inline constexpr double kFastestParting = 10;

/// Settings of a step. The defaults are justified by the measurements in `docs/physics.md`.
struct Settings {
  /// Number of threads that solve groups of bodies; the result is the same.
  int threads = 1;
  Solver solver = Solver::kDirect;
  /// Maximum number of iterations.
  int iterations = 50;
  /// Groups with more rows of joints and contacts than this are not solved directly, except trees of links with no more
  /// bounded rows than this.
  int mostDirectRows = 150;
  /// Softness of all rows [1/(N m s) and the like]; lets the direct method also solve a box on four corners.
  double softness = 1e-8;
  /// Fractions of an error corrected in a step, for joints and for contacts.
  double jointErrorReduction = 0.9;
  double contactErrorReduction = 0.2;
  /// Contact points of two collisions if neither sets a number; negative: no limit. Bullet has at most four.
  long long maxContacts = 20;
  /// Folder in which pieces of meshes are cached for later runs; empty: none.
  std::filesystem::path hullCache = {};
};

}  // namespace pongsim::physics
