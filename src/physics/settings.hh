#pragma once

#include <filesystem>

namespace pongsim::physics {

/// How joints and contacts are solved.
enum class Solver {
  /// Directly for small islands and trees of links, by projected Gauss-Seidel for large ones.
  kDirect,
  /// Projected Gauss-Seidel for all.
  kGaussSeidel,
};

/// Penetration is corrected at no more than this times the step [m/s^2], about the speed that gravity gives in a step,
/// which is the magnitude of the solver's own errors. Fortress's engine corrects all at 1 mm/s.
inline constexpr double kMaxPushAcceleration = 10;

/// Settings of a step. The defaults are justified by the measurements in `docs/physics.md`.
struct Settings {
  /// Number of threads that solve islands; the result is the same.
  int threads = 1;
  Solver solver = Solver::kDirect;
  /// Maximum number of sweeps of Gauss-Seidel.
  int iterations = 50;
  /// Islands with more rows of joints and contacts than this are not solved directly; joints in trees of links do not
  /// count.
  int mostDirectRows = 150;
  /// Compliance of all rows, but not of joints in trees, times the step (constraint force mixing) [s/kg, of rotations
  /// s/(kg m^2)]: makes the matrix of an island with redundant rows, such as a box on four corners, positive definite.
  double cfm = 1e-8;
  /// Fractions of an error that are corrected in a step (error reduction parameters), for joints and for contacts.
  double jointErp = 0.9;
  double contactErp = 0.2;
  /// Contact points of two collisions if neither sets a number; negative: no limit. Bullet has at most four.
  long long maxContacts = 20;
  /// Folder in which pieces of meshes are cached for later runs; empty: none.
  std::filesystem::path hullCache = {};
};

}  // namespace pongsim::physics
