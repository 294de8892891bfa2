#include "ros2/controllers/joint_trajectory_controller/joint_trajectory_controller.hh"

#include <chrono>
#include <cmath>
#include <future>

#include "support/ros2/controlled_robot.hh"

namespace pongsim::ros2 {
namespace {

using Result = control_msgs::action::FollowJointTrajectory::Result;
using Status = action_msgs::GoalStatus;

std::string arm(const std::string& name, const std::string& side) {
  return "<link name='" + name + "_arm'><pose>" + side +
         " 0 0 0 0 0</pose><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia>"
         "</inertial></link><joint name='" +
         name + "' type='revolute'><parent>base</parent><child>" + name +
         "_arm</child><axis><xyz>0 0 1</xyz></axis></joint>";
}

/// Two arms on a base that is fixed to the world.
ControlledRobot arms(const std::string& parameters) {
  return {test::worldOf(test::inWorld("<model name='m'><link name='base'/><joint name='hold' type='fixed'>"
                                      "<parent>world</parent><child>base</child></joint>" +
                                      arm("first", "1") + arm("second", "-1") + "</model>")),
          "m",
          "controller_manager:\n  ros__parameters:\n"
          "    jtc: {type: joint_trajectory_controller/JointTrajectoryController}\n"
          "jtc:\n  ros__parameters:\n    joints: [first, second]\n    state_interfaces: [position, velocity]\n" +
              parameters};
}

trajectory_msgs::JointTrajectory toward(double first, double second, std::int32_t seconds, bool atRest = true) {
  trajectory_msgs::JointTrajectory message;
  message.joint_names = {"second", "first"};
  auto& point = message.points.emplace_back();
  point.positions = {second, first};
  if (atRest) point.velocities = {0, 0};
  point.time_from_start.sec = seconds;
  return message;
}

control_msgs::action::FollowJointTrajectory::Goal goalOf(trajectory_msgs::JointTrajectory trajectory) {
  control_msgs::action::FollowJointTrajectory::Goal goal;
  goal.trajectory = std::move(trajectory);
  return goal;
}

/// Sends goals of the action, and waits for their ends.
class TrajectoryClient {
 public:
  using Action = control_msgs::action::FollowJointTrajectory;
  TrajectoryClient(ControlledRobot& robot) : robot_(robot) {}

  /// @return Whether it was accepted.
  bool send(std::uint8_t number, const Action::Goal& goal) {
    typename SendGoal<Action>::Request request;
    request.goal_id.uuid[0] = number;
    request.goal = goal;
    return call<SendGoal<Action>>("send_goal", request).accepted;
  }
  GetResult<Action>::Response result(std::uint8_t number) {
    typename GetResult<Action>::Request request;
    request.goal_id.uuid[0] = number;
    return call<GetResult<Action>>("get_result", request);
  }
  void cancel(std::uint8_t number) {
    action_msgs::srv::CancelGoal::Request request;
    request.goal_info.goal_id.uuid[0] = number;
    EXPECT_EQ(call<action_msgs::srv::CancelGoal>("cancel_goal", request).return_code, 0);
  }

 private:
  template <ServiceType Service>
  typename Service::Response call(const std::string& name, const typename Service::Request& request) {
    auto answer = std::async(std::launch::async, [&] {
      RosClient<Service> client(robot_.peer(), "/jtc/follow_joint_trajectory/_action/" + name);
      return client.call(request, test::kDeadline);
    });
    while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) robot_.manager().dispatch();
    const auto response = answer.get();
    EXPECT_TRUE(response) << name;
    return response.value_or(typename Service::Response());
  }
  ControlledRobot& robot_;
};

TEST(JointTrajectoryController, CommandsTheSplineOneUpdateAhead) {
  ControlledRobot robot = arms("    command_interfaces: [position]\n");
  robot.start("jtc");
  robot.step(10);
  robot.tell("/jtc/joint_trajectory", toward(1, -2, 2));
  robot.step();
  const Time start = robot.now();
  for (int i = 0; i < 1900; ++i) {
    robot.step();
    const double s = (toSeconds(robot.now() - start) + 0.001) / 2;
    const double part = 3 * s * s - 2 * s * s * s;
    ASSERT_NEAR(robot.hardware().command("first/position")->get(), part, 1e-9);
    ASSERT_NEAR(robot.hardware().command("second/position")->get(), -2 * part, 1e-9);
  }
  robot.step(1000);
  EXPECT_NEAR(robot.model().joint("first")->position(), 1, 1e-3);
  EXPECT_NEAR(robot.model().joint("second")->position(), -2, 1e-3);
}

TEST(JointTrajectoryController, FollowsByVelocitiesAndByEfforts) {
  for (const std::string parameters :
       {"    command_interfaces: [velocity]\n    gains:\n      first: {p: 10.0, ff_velocity_scale: 1.0}\n"
        "      second: {p: 10.0, ff_velocity_scale: 1.0}\n",
        "    command_interfaces: [effort]\n    gains:\n      first: {p: 200.0, d: 20.0, i: 1.0, i_clamp: 5.0}\n"
        "      second: {p: 200.0, d: 20.0}\n",
        "    command_interfaces: [position, velocity]\n"}) {
    ControlledRobot robot = arms(parameters);
    robot.start("jtc");
    robot.step(10);
    robot.tell("/jtc/joint_trajectory", toward(1, -2, 2));
    robot.step(1000);
    EXPECT_NEAR(robot.model().joint("first")->position(), 0.5, 0.02) << parameters;
    robot.step(2000);
    EXPECT_NEAR(robot.model().joint("first")->position(), 1, 0.01) << parameters;
    EXPECT_NEAR(robot.model().joint("second")->position(), -2, 0.01) << parameters;
  }
}

TEST(JointTrajectoryController, EndsGoalsByTheirTolerances) {
  ControlledRobot robot = arms(
      "    command_interfaces: [velocity]\n    constraints:\n      goal_time: 0.5\n      first: {goal: 0.02}\n"
      // without feed-forward the first lags behind
      "    gains:\n      first: {p: 10.0}\n      second: {p: 10.0, ff_velocity_scale: 1.0}\n");
  robot.start("jtc");
  robot.step(10);
  TrajectoryClient client(robot);
  ASSERT_TRUE(client.send(1, goalOf(toward(1, 0, 1))));
  robot.step(1500);
  EXPECT_EQ(client.result(1).status, Status::kStatusSucceeded);
  EXPECT_EQ(client.result(1).result.error_code, Result::kSuccessful);

  control_msgs::action::FollowJointTrajectory::Goal goal = goalOf(toward(-1, 0, 1, false));
  goal.path_tolerance = {{"first", 0.05, 0, 0}};
  ASSERT_TRUE(client.send(2, goal));
  robot.step(1200);
  EXPECT_EQ(client.result(2).status, Status::kStatusAborted);
  EXPECT_EQ(client.result(2).result.error_code, Result::kPathToleranceViolated);

  goal.path_tolerance.clear();
  goal.goal_tolerance = {{"first", 1e-9, 0, 0}};
  ASSERT_TRUE(client.send(3, goal));
  robot.step(1700);
  EXPECT_EQ(client.result(3).result.error_code, Result::kGoalToleranceViolated);

  ASSERT_TRUE(client.send(4, goalOf(toward(2, 0, 3))));
  robot.step(500);
  ASSERT_TRUE(client.send(5, goalOf(toward(-2, 0, 3))));
  EXPECT_EQ(client.result(4).result.error_string, "Current goal preempted by new incoming action.");
  robot.step(500);
  client.cancel(5);
  robot.step(10);
  EXPECT_EQ(client.result(5).status, Status::kStatusCanceled);
  const double held = robot.model().joint("first")->position();
  robot.step(1000);
  EXPECT_NEAR(robot.model().joint("first")->position(), held, 0.05);
  EXPECT_FALSE(client.send(6, {}));
}

TEST(JointTrajectoryController, GoesOnFromASavedState) {
  ControlledRobot robot = arms("    command_interfaces: [position]\n");
  robot.start("jtc");
  robot.step(10);
  robot.tell("/jtc/joint_trajectory", toward(1, -2, 2));
  robot.step(500);
  const auto saved = robot.save();
  robot.step(700);
  const double first = robot.model().joint("first")->position();
  robot.restore(saved);
  robot.step(700);
  EXPECT_EQ(robot.model().joint("first")->position(), first);
}

}  // namespace
}  // namespace pongsim::ros2
