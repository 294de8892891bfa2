#include "ros2/services/entity_state.hh"

#include <gtest/gtest.h>

#include <limits>

#include "support/running_world.hh"

namespace pongsim::ros2::entity_state_test {
namespace {

namespace si = simulation_interfaces;
using Request = si::srv::SetEntityState::Request;
using Response = si::srv::SetEntityState::Response;

class EntityStateTest : public testing::Test {
 protected:
  static Request request(const std::string& entity) {
    Request asked;
    asked.entity = entity;
    return asked;
  }
  Result set(const Request& asked) { return setState(finder_, asked); }
  Model ball() { return world_.model("ball"); }
  si::EntityState stateOfBall() { return stateOf(ball(), world_.simulation().time(), accelerations_); }
  /// As in the system.
  void step() {
    world_.step(1);
    accelerations_.stepped(world_.simulation().world(), {.time = {}, .dt = world_.simulation().stepSize()});
  }

  test::RunningWorld world_{
      std::string("<model name='ball'><pose>1 2 3 0 0 0</pose><link name='l'><pose>0 0 1 0 0 0</pose></link></model>"
                  "<model name='wall'><static>true</static><link name='l'/></model>"
                  "<model name='truck'><pose>0 0 50 0 0 1.5707963267948966</pose><link name='l'/></model>")};
  EntityFinder finder_{world_.simulation().world(), {}};
  Accelerations accelerations_;
};

TEST_F(EntityStateTest, IsToldInTheWorldFrame) {
  ball().setVelocity({1, 0, 0}, {0, 1, 0});
  const si::EntityState state = stateOfBall();
  EXPECT_EQ(state.header.frame_id, "world");
  EXPECT_EQ(vectorOf(state.pose.position), Vector3(1, 2, 3));
  EXPECT_EQ(state.pose.orientation.w, 1);
  // of the model's frame, not of its link's
  EXPECT_TRUE(vectorOf(state.twist.linear).isApprox(Vector3(1, 0, 0)));
  EXPECT_TRUE(vectorOf(state.twist.angular).isApprox(Vector3(0, 1, 0)));
}

TEST_F(EntityStateTest, HasTheTimeOfTheSimulation) {
  world_.step(1500);
  const si::EntityState state = stateOfBall();
  EXPECT_EQ(state.header.stamp.sec, 1);
  EXPECT_EQ(state.header.stamp.nanosec, 500'000'000U);
}

TEST_F(EntityStateTest, MeasuresTheAccelerationFromTheFirstRequestOn) {
  step();
  EXPECT_TRUE(vectorOf(stateOfBall().acceleration.linear).isZero(0));
  step();
  EXPECT_TRUE(vectorOf(stateOfBall().acceleration.linear).isApprox(Vector3(0, 0, -9.8), 1e-6));
  EXPECT_TRUE(vectorOf(stateOf(world_.model("wall"), Time(0), accelerations_).acceleration.linear).isZero(0));
  world_.simulation().remove(ball());
  step();
}

TEST_F(EntityStateTest, IsSetInTheWorldOrInAnyFrame) {
  Request asked = request("ball");
  asked.set_pose = asked.set_twist = true;
  asked.state.pose.position = {4, 5, 6};
  asked.state.twist.linear = {1, 2, 3};
  asked.state.twist.angular = {0, 0, 1};
  EXPECT_EQ(set(asked), succeeded());
  EXPECT_TRUE(ball().pose().position.isApprox(Vector3(4, 5, 6)));
  EXPECT_TRUE(vectorOf(stateOfBall().twist.linear).isApprox(Vector3(1, 2, 3)));

  // the truck faces y and drives at 10 m/s
  world_.model("truck").setVelocity({0, 10, 0}, {0, 0, 0});
  asked.state.header.frame_id = "truck";
  asked.state.pose.position = {1, 0, 0};
  asked.state.twist.linear = {2, 0, 0};
  EXPECT_EQ(set(asked), succeeded());
  EXPECT_TRUE(ball().pose().position.isApprox(Vector3(0, 1, 50))) << ball().pose().position.transpose();
  EXPECT_TRUE(vectorOf(stateOfBall().twist.linear).isApprox(Vector3(0, 12, 0)));
}

TEST_F(EntityStateTest, SetsOnlyWhatTheFlagsSay) {
  ball().setVelocity({1, 0, 0}, {0, 0, 0});
  Request asked = request("ball");
  asked.state.pose.position = {4, 5, 6};
  asked.state.twist.linear = {9, 9, 9};
  EXPECT_EQ(set(asked), succeeded());
  EXPECT_EQ(ball().pose().position, Vector3(1, 2, 3));
  asked.set_pose = true;
  EXPECT_EQ(set(asked), succeeded());
  EXPECT_TRUE(ball().pose().position.isApprox(Vector3(4, 5, 6)));
  EXPECT_TRUE(vectorOf(stateOfBall().twist.linear).isApprox(Vector3(1, 0, 0)));
}

TEST_F(EntityStateTest, MovesWhatIsStaticButGivesItNoVelocity) {
  Request asked = request("wall");
  asked.set_pose = asked.set_twist = true;
  asked.state.pose.position = {4, 5, 6};
  EXPECT_EQ(set(asked), succeeded());
  EXPECT_TRUE(world_.model("wall").pose().position.isApprox(Vector3(4, 5, 6)));
  asked.state.twist.linear.x = 1;
  asked.state.pose.position = {0, 0, 0};
  EXPECT_EQ(set(asked), failed("'wall' is static: it can't be given a velocity or an acceleration"));
  EXPECT_TRUE(world_.model("wall").pose().position.isApprox(Vector3(4, 5, 6)));
}

TEST_F(EntityStateTest, SaysWhatItCantSet) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(set(request("bell")), notFound("there is no entity 'bell'"));
  EXPECT_EQ(set(request("")), notFound("no entity is given"));

  Request asked = request("ball");
  asked.set_pose = true;
  asked.state.pose.orientation = {0, 0, 0, 0};
  EXPECT_EQ(set(asked), refused(Response::kInvalidPose, "the quaternion's length is not 1"));
  asked.state.pose.orientation = {0, 0, 0, 1};
  asked.state.pose.position.x = kNan;
  EXPECT_EQ(set(asked), refused(Response::kInvalidPose, "the pose is not finite"));
  asked.state.pose.position.x = 1e300;
  EXPECT_EQ(set(asked).result, Response::kInvalidPose);
  asked.state.pose.position.x = 0;
  asked.state.header.frame_id = "moon";
  EXPECT_EQ(set(asked).result, Response::kInvalidPose);
  asked.state.header.frame_id = "";
  asked.set_twist = true;
  asked.state.twist.angular.z = kNan;
  EXPECT_EQ(set(asked), failed("the twist is not finite"));
  asked.state.twist.angular.z = 1e9;
  EXPECT_EQ(set(asked), failed("the twist has a number above 1000000"));
  EXPECT_EQ(ball().pose().position, Vector3(1, 2, 3));
}

TEST_F(EntityStateTest, SaysThatAnAccelerationIsNotSet) {
  Request asked = request("ball");
  asked.set_acceleration = true;
  asked.state.acceleration.linear.x = 1;
  EXPECT_EQ(set(asked).result, Result::kResultFeatureUnsupported);
  asked.set_twist = true;
  EXPECT_EQ(set(asked), refused(Result::kResultOk, "the acceleration is ignored: apply forces instead"));
}

}  // namespace
}  // namespace pongsim::ros2::entity_state_test
