// The systems together: the simulation's node, and the plugin of a robot whose controllers run inside.
#include <ignition/msgs/model.pb.h>

#include <chrono>
#include <functional>
#include <future>

#include "ros2/node/service.hh"
#include "ros2/types/controller_manager_services.hh"
#include "ros2/types/std_msgs.hh"
#include "support/running_world.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

namespace srv = controller_manager_msgs::srv;
using pongsim::test::RunningWorld;
using Words = std::vector<std::string>;

class RobotControllersTest : public testing::Test {
 protected:
  /// A model whose joint "hinge" turns, with the plugin, in a world with the simulation's node.
  std::string world(const std::string& parameters, const std::string& more = "",
                    const std::string& hardware = "gz_ros2_control/GazeboSimSystem") {
    const std::string file = folder_.write("controllers.yaml", parameters);
    return "<plugin filename='pongsim-ros2-system' name='pongsim::systems::Ros2'><domain>" + std::to_string(domain_) +
           "</domain></plugin><gravity>0 0 0</gravity><model name='m'><link name='base'/><link name='arm'><inertial>"
           "<mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link>"
           "<joint name='hold' type='fixed'><parent>world</parent><child>base</child></joint>"
           "<joint name='hinge' type='revolute'><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis>"
           "</joint><plugin filename='gz_ros2_control-system' name='gz_ros2_control::GazeboSimROS2ControlPlugin'>"
           "<parameters>" +
           file + "</parameters>" + more + "<ros2_control name='hardware' type='system'><hardware><plugin>" + hardware +
           "</plugin></hardware><joint name='hinge'><command_interface name='velocity'/>"
           "<state_interface name='position'/></joint></ros2_control></plugin></model>";
  }

  /// Steps the world while another thread waits for a service.
  template <ServiceType Service>
  typename Service::Response call(RunningWorld& running, const std::string& service,
                                  const typename Service::Request& request) {
    auto answer = std::async(std::launch::async, [&] {
      RosClient<Service> client(peer_, service);
      return client.call(request, test::kDeadline);
    });
    while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) running.step(1);
    const auto response = answer.get();
    EXPECT_TRUE(response) << service;
    return response.value_or(typename Service::Response());
  }

  void spawn(RunningWorld& running, const std::string& name, const std::string& space = "") {
    EXPECT_TRUE(call<srv::LoadController>(running, space + "/controller_manager/load_controller", {name}).ok);
    EXPECT_TRUE(call<srv::ConfigureController>(running, space + "/controller_manager/configure_controller", {name}).ok);
    srv::SwitchController::Request request;
    request.activate_controllers = {name};
    request.strictness = srv::SwitchController::Request::kStrict;
    EXPECT_TRUE(call<srv::SwitchController>(running, space + "/controller_manager/switch_controller", request).ok);
  }

  static std::string said(const std::function<void()>& act) {
    testing::internal::CaptureStderr();
    act();
    return testing::internal::GetCapturedStderr();
  }

  const int domain_ = test::testDomain();
  test::TempFolder folder_;
  Participant participant_{{.domain = domain_}};
  RosNode peer_{participant_, {.name = "peer"}};
};

const std::string kTurner =
    "controller_manager:\n  ros__parameters:\n    update_rate: 500\n"
    "    turner: {type: velocity_controllers/JointGroupVelocityController}\n"
    "turner:\n  ros__parameters:\n    joints: [hinge]\n";

TEST_F(RobotControllersTest, DriveJointsAndRepeatBitForBit) {
  RunningWorld running(world(kTurner));
  EXPECT_EQ(said([&] { running.step(1); }), "");
  spawn(running, "turner");
  std_msgs::Float64MultiArray command;
  command.data = {2};
  const auto publisher = peer_.advertise<std_msgs::Float64MultiArray>("/turner/commands");
  ASSERT_TRUE(test::waitUntil([&] {
    publisher->publish(command);
    running.step(10);
    return running.model("m").joint("hinge")->velocity() > 1.9;
  }));
  const auto state = running.simulation().saveState();
  running.step(100);
  const auto hash = running.simulation().stateHash();
  EXPECT_EQ(running.simulation().restoreState(state).error, "");
  running.step(100);
  EXPECT_EQ(running.simulation().stateHash(), hash);
  // they stay active, without a command
  Diagnostics diagnostics;
  running.simulation().reset(diagnostics);
  running.step(100);
  EXPECT_EQ(running.model("m").joint("hinge")->position(), 0);
  const auto listed = call<srv::ListControllers>(running, "/controller_manager/list_controllers", {});
  ASSERT_EQ(listed.controller.size(), 1u);
  EXPECT_EQ(listed.controller[0].state, "active");
}

TEST_F(RobotControllersTest, HaveTheNamespaceAndNamesOfThePlugin) {
  std::string parameters = kTurner;
  parameters.replace(0, parameters.find('\n'), "/**/controller_manager:");
  parameters.replace(parameters.find("\nturner:"), 8, "\n/**/turner:");
  RunningWorld running(
      world(parameters, "<ros><namespace>robot</namespace><remapping>~/commands:=/turn</remapping></ros>"));
  spawn(running, "turner", "/robot");
  ASSERT_TRUE(test::waitUntil([&] {
    running.step(1);
    return !participant_.graph().endpointsOn(topicOnWire("/turn"), Graph::Role::kReader).empty();
  }));
}

TEST_F(RobotControllersTest, AreOutsideWhereTheyAreToldOrNotKnown) {
  const std::string onTopics = "the controllers of 'm' run outside of the simulation";
  for (const std::string& text : {world(kTurner, "<controllers>outside</controllers>"),
                                  world(kTurner, "", "topic_based_ros2_control/TopicBasedSystem")}) {
    RunningWorld running(text);
    EXPECT_NE(said([&] { running.step(1); }).find(onTopics), std::string::npos);
  }
  const std::string odd = "controller_manager:\n  ros__parameters:\n    odd: {type: odd_controllers/Odd}\n";
  EXPECT_EQ(RunningWorld::complaintsAbout(world(odd)),
            Words{"controllers of 'm' can't run inside the simulation: 'odd' (odd_controllers/Odd)"});
}

}  // namespace
}  // namespace pongsim::ros2
