#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/lcp/block_matrix.hh"
#include "physics/lcp/joint_order.hh"

namespace pongsim::physics {

/// The equations of joints in trees as rows, those of a joint side by side: `IslandRows` has what they ask for. Holds
/// nothing but memory from island to island.
class BlockRows {
 public:
  /// As many as there is room for side by side, of which `BlockMatrix` takes fewer.
  static constexpr std::size_t kMostRows = 8;
  /// Of each row, for one component of a motion (linear, angular).
  using RowValues = std::array<double, kMostRows>;
  using Motion = std::array<double, 6>;

  /// How a joint's rows act on a body: how the body's motion counts for each, and how the body answers an impulse along
  /// it.
  struct End {
    std::array<RowValues, 6> jacobian;
    std::array<RowValues, 6> response;
    int joint;
    int body;
    /// The end before it at the same body, -1 for none.
    int before;
  };
  /// How a body answers impulses and torques, and how it moves.
  struct Inertia {
    double inverseMass;
    /// World frame, row after row.
    std::array<double, 9> inverseMoments;
  };

  /// Forgets all rows.
  /// @param bodies How many there are.
  /// @param ends How many may be added.
  void begin(std::size_t bodies, std::size_t ends);

  /// Adds an end whose directions are zero.
  End& add(int joint, int body);
  /// Sets how the body's motion counts for a row.
  static void set(End& end, std::size_t row, const auto& linear, const auto& angular) {
    for (std::size_t k = 0; k < 3; ++k) {
      end.jacobian[k][row] = linear[k];
      end.jacobian[k + 3][row] = angular[k];
    }
  }
  /// Finds how the body answers, once the directions are set.
  /// @return The velocities along the rows.
  static RowValues respond(End& end, const Inertia& inertia, const Motion& velocity);

  /// Adds to A what rows of joints at the same body do to each other.
  void couple(const JointOrder& order, std::span<const int> rows, BlockMatrix& A) const;
  /// Likewise what they do to a row with bounds, and it to them.
  /// @param response Of the body, to an impulse along that row.
  void couple(const JointOrder& order, std::span<const int> rows, int body, const Motion& response, int number,
              BlockMatrix& A) const;

  /// Adds what impulses do to the velocities of bodies.
  /// @param x As `BlockMatrix` has it.
  /// @param change Of a body.
  void apply(int body, const JointOrder& order, const BlockMatrix& A, const double* x, Motion& change) const;

 private:
  /// The first `count_` are in use.
  std::vector<End> ends_;
  std::size_t count_ = 0;
  /// Of each body.
  std::vector<int> last_;
};

}  // namespace pongsim::physics
