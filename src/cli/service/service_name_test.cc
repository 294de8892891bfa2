#include "cli/service/service_name.hh"

#include <gtest/gtest.h>

#include "pongsim/node.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

TEST(ServiceOption, GetsItsLeadingSlash) {
  EXPECT_EQ(serviceOption("gazebo/worlds"), "/gazebo/worlds");
  EXPECT_EQ(serviceOption("/gazebo/worlds/"), "/gazebo/worlds");
  EXPECT_THROW(serviceOption("a b"), UsageError);
  EXPECT_THROW(serviceOption(""), UsageError);
}

TEST(NearestService, IsTheOneThatWasMeant) {
  const std::vector<ServiceInfo> known{{"/gazebo/worlds", {}}, {"/server_control", {}}};
  EXPECT_EQ(nearestService("/gazebo/world", known), "did you mean '/gazebo/worlds'?");
  EXPECT_EQ(nearestService("/quite/another", known), "");
}

}  // namespace
}  // namespace pongsim::cli
