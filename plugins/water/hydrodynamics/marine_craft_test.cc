#include "marine_craft.hh"

#include <gtest/gtest.h>

namespace pongsim::marine_craft_test {
namespace {

Vector6 velocity() {
  Vector6 v;
  v << 1.5, -2, 0.5, 0.3, -0.2, 0.7;
  return v;
}

TEST(MarineCraft, IsBrakedByItsVelocity) {
  MarineCraft craft;
  craft.linear(0, 0) = -3;
  craft.linear(5, 1) = 4;
  const Vector6 force = craft.dampingForce(velocity());
  EXPECT_DOUBLE_EQ(force[0], -4.5);
  EXPECT_DOUBLE_EQ(force[5], -8);
  EXPECT_EQ(force[1], 0);
}

TEST(MarineCraft, IsBrakedByTheSquareOfItsVelocity) {
  MarineCraft craft;
  // Y_v|v|, Z_u|q| and K_vr
  craft.quadraticAbs[1](1, 1) = -10;
  craft.quadraticAbs[4](2, 0) = 5;
  craft.quadratic[5](3, 1) = 7;
  const Vector6 force = craft.dampingForce(velocity());
  EXPECT_DOUBLE_EQ(force[1], 40);
  EXPECT_DOUBLE_EQ(force[2], 5 * 1.5 * 0.2);
  EXPECT_DOUBLE_EQ(force[3], 7 * -2 * 0.7);
}

TEST(MarineCraft, DragsAddedMassAlong) {
  MarineCraft craft;
  craft.addedMass(0, 0) = -5;
  craft.addedMass(4, 0) = 2;
  Vector6 acceleration = Vector6::Zero();
  acceleration[0] = 3;
  EXPECT_DOUBLE_EQ(craft.addedMassForce(acceleration)[0], -15);
  EXPECT_DOUBLE_EQ(craft.addedMassForce(acceleration)[4], 6);
}

// entry by entry the matrix of Fortress's sources; it takes and gives no power
TEST(MarineCraft, HasTheCoriolisForcesOfFortress) {
  MarineCraft craft;
  craft.addedMass.diagonal() << -1, -2, -3, -4, -5, -6;
  craft.addedMass(0, 5) = 100;
  const auto m = craft.addedMass.diagonal();
  const Vector6 v = velocity();
  Matrix6 c = Matrix6::Zero();
  c(0, 4) = -m[2] * v[2], c(0, 5) = m[1] * v[1], c(1, 3) = m[2] * v[2];
  c(1, 5) = -m[0] * v[0], c(2, 3) = -m[1] * v[1], c(2, 4) = m[0] * v[0];
  c(3, 4) = -m[5] * v[5], c(3, 5) = m[4] * v[4], c(4, 5) = -m[3] * v[3];
  c.bottomLeftCorner<3, 3>() = -c.topRightCorner<3, 3>().transpose();
  c(4, 3) = -c(3, 4), c(5, 3) = -c(3, 5), c(5, 4) = -c(4, 5);
  EXPECT_NEAR((craft.coriolisForce(v) - c * v).norm(), 0, 1e-12);
  EXPECT_NEAR(craft.coriolisForce(v).dot(v), 0, 1e-12);
}

}  // namespace
}  // namespace pongsim::marine_craft_test
