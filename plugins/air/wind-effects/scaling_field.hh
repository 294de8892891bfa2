#pragma once

#include <array>
#include <limits>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A number that depends on the place, as `<force_approximation_scaling_factor>` gives it in Gazebo's later releases:
/// in each region k (p(x) + q(y) + r(z)) with polynomials of third degree, and 0 outside of all regions.
class ScalingField {
 public:
  /// Reads the `<when>` elements, or one `<k>`, `<px>`, `<qy>`, `<rz>` for everywhere.
  /// @throws Error for an invalid value.
  explicit ScalingField(const Element& element);

  /// @param position World frame [m].
  /// @return The value, at least 0.
  double at(const Vector3& position) const;

 private:
  /// Of a coordinate [m].
  struct Interval {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    /// Whether the limits belong to it.
    bool hasFrom = false;
    bool hasTo = false;

    bool contains(double value) const {
      return (value > from || (hasFrom && value == from)) && (value < to || (hasTo && value == to));
    }
  };
  /// The factors of the third to the zeroth power.
  using Polynomial = std::array<double, 4>;
  struct Piece {
    std::array<Interval, 3> region;
    double factor = 1;
    std::array<Polynomial, 3> polynomials{};
  };

  static Interval intervalOf(const Element& when, char axis);
  static Piece pieceOf(const Element& element);

  std::vector<Piece> pieces_;
};

}  // namespace pongsim
