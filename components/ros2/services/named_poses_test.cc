#include "ros2/services/named_poses.hh"

#include <gtest/gtest.h>

#include "ros2/services/result.hh"
#include "support/running_world.hh"

namespace pongsim::ros2 {
namespace {

class NamedPosesTest : public testing::Test {
 protected:
  test::RunningWorld world_{
      std::string("<frame name='dock'><pose>1 2 3 0 0 0</pose></frame>"
                  "<model name='start'><static>true</static><pose>4 5 6 0 0 0</pose></model>"
                  "<model name='box'><static>true</static><link name='l'/></model>")};
  EntityFinder finder_{world_.simulation().world(), {}};
};

TEST_F(NamedPosesTest, AreFramesOfTheWorldAndModelsWithoutLinks) {
  const auto response = namedPoses(finder_, {});
  EXPECT_EQ(response.result, succeeded());
  ASSERT_EQ(response.poses.size(), 2U);
  EXPECT_EQ(response.poses[0].name, "dock");
  EXPECT_EQ(vectorOf(response.poses[0].pose.position), Vector3(1, 2, 3));
  EXPECT_EQ(response.poses[1].name, "start");
  EXPECT_EQ(vectorOf(response.poses[1].pose.position), Vector3(4, 5, 6));
}

TEST_F(NamedPosesTest, HaveNoTags) {
  EXPECT_TRUE(namedPoses(finder_, {{"parking"}, 0}).poses.empty());
  EXPECT_EQ(namedPoses(finder_, {{}, 7}).result, failed("there is no filter mode 7: 0 is any tag, 1 is all"));
}

TEST_F(NamedPosesTest, HaveNoBounds) {
  const auto response = namedPoseBounds(finder_, "dock");
  EXPECT_EQ(response.result, succeeded());
  EXPECT_EQ(response.bounds, simulation_interfaces::Bounds());
  EXPECT_EQ(namedPoseBounds(finder_, "box").result, notFound("there is no named pose 'box'"));
  EXPECT_EQ(namedPoseBounds(finder_, "").result.result, Result::kResultNotFound);
}

}  // namespace
}  // namespace pongsim::ros2
