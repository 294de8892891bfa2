#include "description/joint.hh"

#include <gtest/gtest.h>

namespace pongsim::description {
namespace {

TEST(JointType, IsNamedAsInTheFormat) {
  EXPECT_EQ(name(JointType::kRevolute), "revolute");
  EXPECT_EQ(name(JointType::kContinuous), "continuous");
  EXPECT_EQ(name(JointType::kPrismatic), "prismatic");
  EXPECT_EQ(name(JointType::kBall), "ball");
  EXPECT_EQ(name(JointType::kFixed), "fixed");
  EXPECT_EQ(name(JointType::kUniversal), "universal");
  EXPECT_EQ(name(JointType::kRevolute2), "revolute2");
  EXPECT_EQ(name(JointType::kScrew), "screw");
  EXPECT_EQ(name(JointType::kGearbox), "gearbox");
}

}  // namespace
}  // namespace pongsim::description
