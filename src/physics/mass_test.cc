#include "physics/mass.hh"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace pongsim::physics {
namespace {

TEST(PrincipalMass, KeepsTheAxesOfADiagonalTensor) {
  description::Inertial inertial;
  inertial.moments = Vector3(3, 1, 2).asDiagonal();
  inertial.X_LinkCom.position = {0.1, 0.2, 0.3};
  const PrincipalMass mass = principalMass(inertial);
  EXPECT_EQ(mass.moments, Vector3(3, 1, 2));
  EXPECT_EQ(mass.X_LinkBody.position, Vector3(0.1, 0.2, 0.3));
  EXPECT_TRUE(mass.X_LinkBody.rotation.vec().isZero(0));
}

TEST(PrincipalMass, ReproducesAFullTensorInTheLinkFrame) {
  description::Inertial inertial;
  inertial.moments << 2, 0.3, -0.2, 0.3, 3, 0.1, -0.2, 0.1, 4;
  inertial.X_LinkCom.rotation = fromRollPitchYaw(0.4, -0.7, 1.1);
  const PrincipalMass mass = principalMass(inertial);

  const Matrix3 outer = inertial.X_LinkCom.rotation.toRotationMatrix();
  const Matrix3 inner = mass.X_LinkBody.rotation.toRotationMatrix();
  const Matrix3 wanted = outer * inertial.moments * outer.transpose();
  const Matrix3 given = inner * mass.moments.asDiagonal() * inner.transpose();
  EXPECT_TRUE(given.isApprox(wanted, 1e-12));
}

TEST(PrincipalMass, RefusesWhatCannotMove) {
  description::Inertial inertial;
  inertial.mass = 0;
  EXPECT_THROW(principalMass(inertial), std::invalid_argument);
  inertial.mass = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(principalMass(inertial), std::invalid_argument);
  inertial.mass = 1;
  inertial.moments = Vector3(1, 1, 0).asDiagonal();
  EXPECT_THROW(principalMass(inertial), std::invalid_argument);
  inertial.moments << 1, 2, 0, 2, 1, 0, 0, 0, 1;
  EXPECT_THROW(principalMass(inertial), std::invalid_argument);
}

}  // namespace
}  // namespace pongsim::physics
