#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/lcp/elimination.hh"

namespace pongsim::physics {

/// A row's part at one of its bodies.
struct RowEnd {
  /// J of the body's velocity: linear, angular.
  std::array<double, 6> jacobian;
  /// M^-1 J^T: the change of the body's velocity by a unit impulse.
  std::array<double, 6> response;
  int row;
  int body;
  /// The end before it at the same body, -1 for none.
  int before;
  /// Of its row in the matrix.
  int place;
};

/// Two numbers side by side.
using Two [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;

/// @return J1 M^-1 J2^T: the velocity along row `one` by a unit impulse of row `other`, at the same body.
inline double coupling(const RowEnd& one, const RowEnd& other) {
  const Two* const x = reinterpret_cast<const Two*>(one.jacobian.data());
  const Two* const y = reinterpret_cast<const Two*>(other.response.data());
  const Two sums = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  return sums[0] + sums[1];
}

/// Adds `factor` times `each` to the sum.
inline void addTimes(std::array<double, 6>& sum, const std::array<double, 6>& each, double factor) {
  Two* const to = reinterpret_cast<Two*>(sum.data());
  const Two* const x = reinterpret_cast<const Two*>(each.data());
  for (int i = 0; i < 3; ++i) to[i] += x[i] * factor;
}

/// Adds to A = J M^-1 J^T the products of an end with itself and with those before it at the same body.
void coupleBefore(std::span<const RowEnd> ends, const RowEnd& end, const UpperRows& A);

/// Does the same for all ends of a body after another, four side by side. Keeps its memory.
class BodyCoupling {
 public:
  /// Adds to A the products of all ends of a body with each other and with themselves. Also writes before A's diagonal.
  /// @param last The body's last end, -1 for none; no two of its ends are of one row.
  void couple(std::span<const RowEnd> ends, int last, const UpperRows& A);

 private:
  std::vector<const RowEnd*> list_;
};

}  // namespace pongsim::physics
