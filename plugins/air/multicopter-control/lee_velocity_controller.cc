#include "lee_velocity_controller.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/LU>

namespace pongsim {

namespace {

// Unit vectors are taken as parallel if the square of their cross product is smaller.
constexpr double kParallel = 1e-3;

}  // namespace

LeeVelocityController::LeeVelocityController(const LeeGains& gains, const VehicleMass& vehicle,
                                             const Allocation& allocation)
    : gains_(gains),
      mass_(vehicle.mass),
      attitudeGain_(vehicle.inertia.inverse().transpose() * gains.attitude),
      angularRateGain_(vehicle.inertia.inverse().transpose() * gains.angularRate) {
  Eigen::Matrix4d inertia = Eigen::Matrix4d::Zero();
  inertia.topLeftCorner<3, 3>() = vehicle.inertia;
  inertia(3, 3) = 1;
  // The least-squares solution: the pseudo-inverse. `*` would instantiate Eigen's product of large matrices.
  const Eigen::Matrix4d squares = allocation.lazyProduct(allocation.transpose());
  const Eigen::Matrix<double, Eigen::Dynamic, 4> pseudoInverse = allocation.transpose().lazyProduct(squares.inverse());
  toSquares_ = pseudoInverse.lazyProduct(inertia);
}

void LeeVelocityController::compute(const BodyMotion& motion, const VelocityCommand& command, const Vector3& gravity,
                                    std::vector<double>& speeds) const {
  const Vector3 wanted = acceleration(motion, command, gravity);
  Eigen::Vector4d demand;
  demand << angularAcceleration(motion, command.yawRate, wanted), -mass_ * wanted.dot(motion.R_WorldBody.col(2));
  speeds.resize(static_cast<std::size_t>(toSquares_.rows()));
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    speeds[i] = std::sqrt(std::max(toSquares_.row(static_cast<Eigen::Index>(i)).dot(demand), 0.0));
  }
}

/// @return The acceleration that the thrust must compensate: gravity and the velocity error's [m/s^2].
Vector3 LeeVelocityController::acceleration(const BodyMotion& motion, const VelocityCommand& command,
                                            const Vector3& gravity) const {
  const Vector3 error = motion.velocity - motion.R_WorldBody * command.velocity;
  const Vector3 excess = error.cwiseProduct(gains_.velocity) / mass_;
  return excess.cwiseMin(gains_.maximumAcceleration).cwiseMax(-gains_.maximumAcceleration) + gravity;
}

Vector3 LeeVelocityController::angularAcceleration(const BodyMotion& motion, double yawRate,
                                                   const Vector3& acceleration) const {
  const Matrix3& R = motion.R_WorldBody;
  // no thrust is needed: the attitude stays
  const double size = acceleration.norm();
  const Vector3 up = size > 0 ? Vector3(-acceleration / size) : Vector3(R.col(2));
  Vector3 forward = R.col(0);
  for (int axis = 1; axis < 3 && forward.cross(up).squaredNorm() < kParallel; ++axis) forward = R.col(axis);

  Matrix3 R_WorldWanted;
  R_WorldWanted.col(2) = up;
  R_WorldWanted.col(1) = up.cross(forward).normalized();
  R_WorldWanted.col(0) = R_WorldWanted.col(1).cross(up);
  const Matrix3 R_WantedBody = R_WorldWanted.transpose() * R;
  const Matrix3 skew = 0.5 * (R_WantedBody - R_WantedBody.transpose());
  const Vector3 attitudeError(skew(2, 1), skew(0, 2), skew(1, 0));
  const Vector3 rateError = motion.angularVelocity - R_WantedBody.transpose() * Vector3(0, 0, yawRate);
  return -attitudeError.cwiseProduct(attitudeGain_) - rateError.cwiseProduct(angularRateGain_);
}

}  // namespace pongsim
