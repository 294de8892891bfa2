#include "dvl_tracking.hh"

#include <Eigen/LU>

namespace pongsim {

void VelocityFit::add(const Vector3& axis, double speed) {
  normal_ += axis * axis.transpose();
  right_ += axis * speed;
  ++beams_;
}

std::optional<VelocityFit::Result> VelocityFit::solve() const {
  // that of beams at right angles to each other is 1, and of beams in a plane zero
  constexpr double kLeastDeterminant = 1e-9;
  if (beams_ < 3 || normal_.determinant() < kLeastDeterminant) return std::nullopt;
  const Matrix3 inverse = normal_.inverse();
  return Result{inverse * right_, inverse};
}

void RunningVariance::add(double value) {
  const double before = mean_;
  mean_ += (value - mean_) / ++count_;
  sum_ += (value - before) * (value - mean_);
}

}  // namespace pongsim
