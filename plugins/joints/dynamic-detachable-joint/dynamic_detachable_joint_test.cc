#include <gtest/gtest.h>
#include <ignition/msgs/attach_detach_request.pb.h>
#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/result.pb.h>

#include <string>
#include <utility>
#include <vector>

#include "support/ask_service.hh"
#include "support/running_world.hh"

namespace pongsim::dynamic_detachable_joint_test {
namespace {

using test::RunningWorld;

constexpr const char* kService = "/model/gripper/dynamic_detachable_joint/attach_detach";
constexpr const char* kState = "/model/gripper/dynamic_detachable_joint/state";

/// A "gripper" held by the world, and boxes 0.2 m and 1 m below its "hand".
std::string worldWith(const std::string& parameters) {
  const std::string inertial = "<inertial><mass>1</mass></inertial>";
  return "<model name='gripper'><pose>0 0 3 0 0 0</pose><link name='hand'>" + inertial +
         "</link><joint name='hold' type='fixed'><parent>world</parent><child>hand</child></joint>"
         "<plugin filename='gz-sim-dynamic-detachable-joint-system' name='gz::sim::systems::DynamicDetachableJoint'>" +
         parameters + "</plugin></model><model name='near'><pose>0 0 2.8 0 0 0</pose><link name='body'>" + inertial +
         "</link></model><model name='far'><pose>0 0 2 0 0 0</pose><link name='body'>" + inertial + "</link></model>";
}

constexpr const char* kHand = "<parent_link>hand</parent_link><attach_distance>0.3</attach_distance>";

/// @return The reason if it was refused.
std::string ask(RunningWorld& world, const std::string& command, const std::string& model = "near",
                const std::string& link = "body", const std::string& service = kService) {
  ignition::msgs::AttachDetachRequest request;
  ignition::msgs::AttachDetachRequest::Command value = ignition::msgs::AttachDetachRequest::COMMAND_UNSPECIFIED;
  if (command == "attach") value = ignition::msgs::AttachDetachRequest::ATTACH;
  if (command == "detach") value = ignition::msgs::AttachDetachRequest::DETACH;
  request.set_command(value);
  request.set_child_model_name(model);
  request.set_child_link_name(link);
  ignition::msgs::Result reply;
  const CallResult result = test::askService(world.simulation().transport(), service, request, reply);
  EXPECT_EQ(result.outcome, CallOutcome::kDone) << result.error;
  EXPECT_EQ(reply.error_code(), reply.message().empty() ? 0 : 1);
  return reply.message();
}

double height(RunningWorld& world, const char* model = "near") { return world.model(model).pose().position.z(); }

TEST(DynamicDetachableJoint, HoldsWhatItIsToldUntilItIsToLetGo) {
  RunningWorld world(worldWith(kHand));
  std::vector<ignition::msgs::Entity> states;
  world.listen(kState, states);
  EXPECT_EQ(ask(world, "attach"), "");
  world.step(500);
  EXPECT_NEAR(height(world), 2.8, 1e-3);
  EXPECT_LT(height(world, "far"), 1);
  EXPECT_EQ(ask(world, "detach"), "");
  world.step(500);
  EXPECT_NEAR(height(world), 2.8 - 9.8 / 8, 0.02);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].id(), world.model("near").link("body")->id().value);
  EXPECT_EQ(states[0].type(), ignition::msgs::Entity::LINK);
  EXPECT_EQ(states[1].id(), 0U);
  EXPECT_EQ(states[1].type(), ignition::msgs::Entity::NONE);
}

TEST(DynamicDetachableJoint, HasTheServiceAndTheTopicThatItIsTold) {
  RunningWorld world(
      worldWith(std::string(kHand) + "<service_name>grip</service_name><output_topic>held</output_topic>"));
  std::vector<ignition::msgs::Entity> states;
  world.listen("/held", states);
  EXPECT_EQ(ask(world, "attach", "near", "body", "/grip"), "");
  world.step(1);
  EXPECT_EQ(states.size(), 1U);
}

TEST(DynamicDetachableJoint, SaysWhyItDoesNot) {
  RunningWorld world(worldWith(kHand));
  EXPECT_EQ(ask(world, "detach"), "no link is attached");
  EXPECT_EQ(ask(world, "?"), "the command must be ATTACH or DETACH");
  EXPECT_EQ(ask(world, "attach", "box"), "'box::body' is no link in the world");
  EXPECT_EQ(ask(world, "attach", "near", "knob"), "'near::knob' is no link in the world");
  EXPECT_EQ(ask(world, "attach", ""), "'::body' is no link in the world");
  EXPECT_EQ(ask(world, "attach", "far"), "link 'far::body' is too far away: 1.000000 m");
  EXPECT_EQ(ask(world, "attach"), "");
  EXPECT_EQ(ask(world, "attach", "far"), "link 'near::body' is attached already");
  EXPECT_EQ(ask(world, "detach", "far"), "link 'near::body' is attached, not 'far::body'");
  EXPECT_NE(ask(world, "attach", "__model__", "hand"), "");
}

TEST(DynamicDetachableJoint, HoldsOrDoesNotAsInASavedStateAndLetsGoInAReset) {
  RunningWorld world(worldWith(kHand));
  EXPECT_EQ(ask(world, "attach"), "");
  world.step(10);
  const std::vector<std::byte> held = world.simulation().saveState();
  EXPECT_EQ(ask(world, "detach"), "");
  world.step(10);
  EXPECT_TRUE(world.simulation().restoreState(held));
  world.step(300);
  EXPECT_NEAR(height(world), 2.8, 1e-3);
  EXPECT_EQ(ask(world, "detach"), "");
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  EXPECT_EQ(ask(world, "attach"), "");
  world.simulation().reset(diagnostics);
  world.step(300);
  EXPECT_LT(height(world), 2.4);
  EXPECT_EQ(ask(world, "detach"), "no link is attached");
}

TEST(DynamicDetachableJoint, IsLeftOutWithTheReason) {
  const std::string left = "dynamic-detachable-joint of gripper is left out: ";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "no <parent_link> is given"},
           {"<parent_link>arm</parent_link>", "<parent_link> 'arm' is not a link of model 'gripper'"},
           {"<parent_link>hand</parent_link><attach_distance>-1</attach_distance>",
            "<attach_distance> must be zero or more"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{left + message});
  }
}

}  // namespace
}  // namespace pongsim::dynamic_detachable_joint_test
