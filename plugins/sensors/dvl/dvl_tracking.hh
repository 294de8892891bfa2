#pragma once

#include <optional>

#include "pongsim/types.hh"

namespace pongsim {

/// Estimates the velocity of a DVL from the speeds along its beams: v with least squares of the differences of b.v and
/// s, for all beams with the axis b and the speed s.
class VelocityFit {
 public:
  /// @param axis Unit vector.
  /// @param speed Along it [m/s].
  void add(const Vector3& axis, double speed);

  struct Result {
    /// [m/s]
    Vector3 velocity = Vector3::Zero();
    /// (B^T B)^-1: the covariance, where each speed has the variance 1.
    Matrix3 covariance = Matrix3::Zero();
  };
  /// @return Nothing unless three beams point into different directions.
  std::optional<Result> solve() const;
  int beams() const { return beams_; }

 private:
  /// B^T B and B^T s, where the rows of B are the axes.
  Matrix3 normal_ = Matrix3::Zero();
  Vector3 right_ = Vector3::Zero();
  int beams_ = 0;
};

/// Mean and variance of numbers, by Welford's algorithm.
class RunningVariance {
 public:
  void add(double value);
  double mean() const { return mean_; }
  /// @return Zero for less than two numbers.
  double variance() const { return count_ > 1 ? sum_ / (count_ - 1) : 0; }

 private:
  int count_ = 0;
  double mean_ = 0;
  /// Of the squared differences from the mean.
  double sum_ = 0;
};

}  // namespace pongsim
