#include "description/added_mass.hh"

#include <Eigen/Cholesky>

namespace pongsim::description {

namespace {

// Least share of a diagonal element that elimination must leave: below it the inverse has too few correct digits.
constexpr double kLeastPivot = 1e-9;

/// The spatial inertia of a body about the origin of the link frame.
AddedMass inertiaOf(double mass, const Pose& X_LinkCom, const Matrix3& moments) {
  const Vector3& c = X_LinkCom.position;
  Matrix3 cross;
  cross << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  const Matrix3 R = X_LinkCom.rotation.toRotationMatrix();
  AddedMass result;
  result.topLeftCorner<3, 3>() = mass * Matrix3::Identity();
  result.topRightCorner<3, 3>() = -mass * cross;
  result.bottomLeftCorner<3, 3>() = mass * cross;
  result.bottomRightCorner<3, 3>() = R * moments * R.transpose() - mass * cross * cross;
  return result;
}

}  // namespace

bool isPossible(const AddedMass& added, double mass, const Pose& X_LinkCom, const Matrix3& moments) {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  const Matrix sum = added + inertiaOf(mass, X_LinkCom, moments);
  const Eigen::Matrix<double, 6, 1> diagonal = sum.diagonal();
  if (!(diagonal.minCoeff() > 0)) return false;
  // scaled to a diagonal of ones, because masses and moments differ by any factor
  const Eigen::Matrix<double, 6, 1> scale = diagonal.cwiseSqrt().cwiseInverse();
  const Matrix scaled = scale.asDiagonal() * sum * scale.asDiagonal();
  const Eigen::LLT<Matrix> factors(scaled);
  if (factors.info() != Eigen::Success) return false;
  return factors.matrixLLT().diagonal().array().square().minCoeff() > kLeastPivot;
}

}  // namespace pongsim::description
