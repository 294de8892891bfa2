#include "physics/spatial_inertia.hh"

#include <Eigen/Cholesky>
#include <cassert>

#include "physics/convert.hh"
#include "physics/motion.hh"

namespace pongsim::physics {

namespace {

using Matrix6 = description::AddedMass;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// each multiplies the error by about the angle of half a step
constexpr int kMostRounds = 5;
// a smaller relative change is rounding
constexpr double kSmallestChange = 1e-15;

Vector6 spatial(const btVector3& linear, const btVector3& angular) {
  return (Vector6() << fromBullet(linear), fromBullet(angular)).finished();
}

/// @return The orientation after `dt` [s].
Matrix3 turnedBy(const btMatrix3x3& R, const btVector3& w, double dt) {
  const btMatrix3x3 then = moved(btTransform(R), btVector3(0, 0, 0), w, dt).getBasis();
  Matrix3 result;
  for (int row = 0; row < 3; ++row) result.row(row) = fromBullet(then[row]).transpose();
  return result;
}

/// @return A matrix of the body frame in the axes of the world.
Matrix6 inWorld(const Matrix6& matrix, const Matrix3& R_WorldBody) {
  Matrix6 result;
  for (const int row : {0, 3}) {
    for (const int column : {0, 3}) {
      result.block<3, 3>(row, column) = R_WorldBody * matrix.block<3, 3>(row, column) * R_WorldBody.transpose();
    }
  }
  return result;
}

}  // namespace

// T gives the velocity of the link frame, whose origin is at -p, from that of the body frame: the energy V^T T^T A T V
// / 2 is the same in both.
SpatialInertia::SpatialInertia(const description::AddedMass& ofLink, const Pose& X_LinkBody) {
  const Vector3& p = X_LinkBody.position;
  Matrix3 cross;
  cross << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  const Matrix3 R = X_LinkBody.rotation.toRotationMatrix();
  Matrix T = Matrix::Zero();
  T.topLeftCorner<3, 3>() = T.bottomRightCorner<3, 3>() = R;
  T.topRightCorner<3, 3>() = cross * R;
  const Matrix product = T.transpose() * ofLink * T;
  ofFluid_ = (product + product.transpose()) / 2;
  inertia_ = inverse_ = inverseAhead_ = Matrix::Zero();
}

bool SpatialInertia::isPossibleWith(double mass, const Vector3& moments) const {
  return description::isPossible(ofFluid_, mass, Pose(), moments.asDiagonal());
}

void SpatialInertia::setMass(double mass, const Vector3& moments) {
  assert(isPossibleWith(mass, moments));
  inertia_ = ofFluid_;
  inertia_.diagonal().head<3>().array() += mass;
  inertia_.diagonal().tail<3>() += moments;
  const Matrix solved = inertia_.llt().solve(Matrix::Identity());
  inverse_ = (solved + solved.transpose()) / 2;
}

// The momentum P stays, and the angular momentum L about the centre of mass changes by -v x P, because that moves. The
// velocity belongs to half a step before the orientation, the new one to half a step after it.
SpatialInertia::Wrench SpatialInertia::advance(const btMatrix3x3& R_WorldBody, const btVector3& v, const btVector3& w,
                                               double dt, bool isHeld) {
  const Vector6 before = spatial(v, w);
  const Vector6 start = inWorld(inertia_, turnedBy(R_WorldBody, -w, dt / 2)) * before;
  const Vector3 P = start.head<3>(), v_Before = before.head<3>();
  Vector6 next = before, momentum = start;
  Matrix3 R_Ahead = turnedBy(R_WorldBody, w, dt / 2);
  // the next velocity of a held body depends on its joints, so the last is taken
  for (int i = 0; i <= (isHeld ? 0 : kMostRounds); ++i) {
    const Vector3 v_Next = next.head<3>();
    momentum.tail<3>() = start.tail<3>() - dt / 2 * (v_Before + v_Next).cross(P);
    if (isHeld) break;
    const Vector6 last = next;
    next = inWorld(inverse_, R_Ahead) * momentum;
    R_Ahead = turnedBy(R_WorldBody, toBullet(Vector3(next.tail<3>())), dt / 2);
    if ((next - last).squaredNorm() <= kSmallestChange * kSmallestChange * next.squaredNorm()) break;
  }
  inverseAhead_ = inWorld(inverse_, R_Ahead);
  const Vector6 wrench = (momentum - inWorld(inertia_, R_Ahead) * before) / dt;
  return {toBullet(Vector3(wrench.head<3>())), toBullet(Vector3(wrench.tail<3>()))};
}

SpatialInertia::Matrix SpatialInertia::ahead() const { return inverseAhead_.llt().solve(Matrix::Identity()); }

SpatialInertia::Motion SpatialInertia::respond(const btVector3& linear, const btVector3& angular) const {
  const Vector6 change = inverseAhead_ * spatial(linear, angular);
  return {change[0], change[1], change[2], change[3], change[4], change[5]};
}

}  // namespace pongsim::physics
