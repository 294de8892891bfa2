#include "ros2/services/entity_finder.hh"

#include <gtest/gtest.h>

#include "support/running_world.hh"

namespace pongsim::ros2 {
namespace {

class EntityFinderTest : public testing::Test {
 protected:
  static std::vector<std::string> namesOf(const std::vector<Model>& models) {
    std::vector<std::string> names;
    for (const Model& model : models) names.push_back(model.scopedName());
    return names;
  }

  test::RunningWorld world_{std::string(
      "<gravity>0 0 0</gravity><frame name='dock'><pose>0 0 9 0 0 0</pose></frame>"
      "<model name='cart'><pose>1 2 0 0 0 0</pose><link name='base'/><link name='mast'><pose>0 0 1 0 0 0</pose></link>"
      "</model>"
      "<model name='spot'><static>true</static><pose>7 0 0 0 0 0</pose></model>"
      "<model name='outer'><static>true</static><model name='inner'><link name='l'/></model></model>")};
  EntityFinder finder_{world_.simulation().world(), Frames{.prefix = "r1/"}};
};

TEST_F(EntityFinderTest, TellsEntitiesFromPoses) {
  EXPECT_EQ(namesOf(finder_.entities()), (std::vector<std::string>{"cart", "outer"}));
  EXPECT_EQ(namesOf(finder_.poses()), std::vector<std::string>{"spot"});
}

TEST_F(EntityFinderTest, FindsByName) {
  EXPECT_TRUE(finder_.find("cart"));
  EXPECT_TRUE(finder_.find("outer::inner"));
  EXPECT_EQ(finder_.find("").error, "no entity is given");
  EXPECT_EQ(finder_.find("cat").error, "there is no entity 'cat'");
}

TEST_F(EntityFinderTest, KnowsFramesAsRosNamesThem) {
  EXPECT_EQ(finder_.frame("")->pose, Pose());
  EXPECT_EQ(finder_.frame("world")->pose, Pose());
  EXPECT_EQ(finder_.frame("w")->pose, Pose());
  EXPECT_TRUE(finder_.frame("cart")->pose.position.isApprox(Vector3(1, 2, 0)));
  EXPECT_TRUE(finder_.frame("cart/mast")->pose.position.isApprox(Vector3(1, 2, 1)));
  EXPECT_TRUE(finder_.frame("r1/cart/mast")->pose.position.isApprox(Vector3(1, 2, 1)));
  EXPECT_TRUE(finder_.frame("cart::mast")->pose.position.isApprox(Vector3(1, 2, 1)));
  EXPECT_TRUE(finder_.frame("dock")->pose.position.isApprox(Vector3(0, 0, 9)));
  EXPECT_EQ(finder_.frame("cart/mist").error,
            "there is no frame 'cart/mist': it is 'world', a model, 'model/link' or a <frame> of the world");
}

TEST_F(EntityFinderTest, KnowsHowFramesMove) {
  world_.model("cart").setVelocity({1, 0, 0}, {0, 1, 0});
  // v + w x r with r = (0, 0, 1)
  const MovingFrame mast = *finder_.frame("cart/mast");
  EXPECT_TRUE(mast.linear.isApprox(Vector3(2, 0, 0))) << mast.linear.transpose();
  EXPECT_TRUE(mast.angular.isApprox(Vector3(0, 1, 0)));
  const MovingFrame spot = *finder_.frame("spot");
  EXPECT_EQ(spot.linear, Vector3::Zero());
}

}  // namespace
}  // namespace pongsim::ros2
