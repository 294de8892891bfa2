#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/lcp/block_matrix.hh"
#include "physics/lcp/joint_order.hh"

namespace pongsim::physics {

/// The equations of joints in trees: the blocks of J and M^-1 J^T for each joint and body, with the joint's rows as
/// columns. `IslandRows` has the right-hand sides. Keeps nothing but memory from island to island.
class BlockRows {
 public:
  /// Columns of a block; `BlockMatrix` takes fewer.
  static constexpr std::size_t kMostRows = 8;
  /// A number for each row of a joint.
  using RowValues = std::array<double, kMostRows>;
  using Motion = std::array<double, 6>;

  /// The rows of a joint at one of its bodies.
  struct End {
    /// J^T: linear, angular.
    std::array<RowValues, 6> jacobian;
    /// M^-1 J^T.
    std::array<RowValues, 6> response;
    int joint;
    int body;
    /// The end before it at the same body, -1 for none.
    int before;
  };
  /// M^-1 of a body.
  struct Inertia {
    double inverseMass;
    /// World frame, row after row.
    std::array<double, 9> inverseMoments;
  };

  /// Forgets all rows.
  /// @param bodies How many there are.
  /// @param ends How many may be added.
  void begin(std::size_t bodies, std::size_t ends);

  /// Adds an end with a zero J.
  End& add(int joint, int body);
  /// Sets J of a row.
  static void set(End& end, std::size_t row, const auto& linear, const auto& angular) {
    for (std::size_t k = 0; k < 3; ++k) {
      end.jacobian[k][row] = linear[k];
      end.jacobian[k + 3][row] = angular[k];
    }
  }
  /// Computes M^-1 J^T, once J is set.
  /// @return J v: the velocities along the rows.
  static RowValues respond(End& end, const Inertia& inertia, const Motion& velocity);

  /// Adds the products J M^-1 J^T of joints at the same body to A.
  void couple(const JointOrder& order, std::span<const int> rows, BlockMatrix& A) const;
  /// Likewise the products of joints with a bounded row.
  /// @param response M^-1 J^T of that row, at the body.
  void couple(const JointOrder& order, std::span<const int> rows, int body, const Motion& response, int number,
              BlockMatrix& A) const;

  /// Adds M^-1 J^T x to the velocity change of a body.
  /// @param x The impulses, as `BlockMatrix` has them.
  void apply(int body, const JointOrder& order, const BlockMatrix& A, const double* x, Motion& change) const;

 private:
  /// The first `count_` are in use.
  std::vector<End> ends_;
  std::size_t count_ = 0;
  /// Of each body.
  std::vector<int> last_;
};

}  // namespace pongsim::physics
