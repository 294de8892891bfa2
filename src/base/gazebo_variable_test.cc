#include "pongsim/program/gazebo_variable.hh"

#include <gtest/gtest.h>

#include "support/environment_variable.hh"

namespace pongsim {
namespace {

TEST(GazeboVariable, HasTheValueOfFortressNameElseOfTheLaterOne) {
  test::EnvironmentVariable fortress("IGN_PARTITION"), later("GZ_PARTITION");
  fortress.unset();
  later.unset();
  EXPECT_EQ(gazebo::kPartition.value(), "");
  later.set("later");
  EXPECT_EQ(gazebo::kPartition.value(), "later");
  fortress.set("");
  EXPECT_EQ(gazebo::kPartition.value(), "later");
  fortress.set("fortress");
  EXPECT_EQ(gazebo::kPartition.value(), "fortress");
}

}  // namespace
}  // namespace pongsim
