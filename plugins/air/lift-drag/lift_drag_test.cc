#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/example_world.hh"
#include "support/running_world.hh"

namespace pongsim::lift_drag_test {
namespace {

using test::RunningWorld;

constexpr const char* kWing =
    "<link_name>wing</link_name><cla>4</cla><cda>0.5</cda><area>3</area><air_density>1.2</air_density>";

/// Model "m" with "wing", of 2 kg, a flap that a joint turns, and in the model "inner" a "fin".
std::string worldWith(const std::string& parameters) {
  const std::string inertial =
      "<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
  return "<gravity>0 0 0</gravity><model name='m'><link name='wing'>" + inertial +
         "</link><link name='flap'><pose>0 5 0 0 0 0</pose>" + inertial +
         "</link><joint name='hinge' type='revolute'><parent>world</parent><child>flap</child>"
         "<axis><xyz>0 1 0</xyz></axis></joint>"
         "<model name='inner'><link name='fin'><pose>0 0 9 0 0 0</pose>" +
         inertial +
         "</link></model>"
         "<plugin filename='ignition-gazebo-lift-drag-system' name='ignition::gazebo::systems::LiftDrag'>" +
         parameters + "</plugin></model>";
}

/// @return What the first step gives a link that moves so.
std::pair<Vector3, Vector3> accelerations(RunningWorld& world, Link link, const Vector3& linear,
                                          const Vector3& angular = Vector3::Zero()) {
  link.setVelocity(linear, angular);
  world.step(1);
  return {(link.linearVelocity() - linear) / 1e-3, (link.angularVelocity() - angular) / 1e-3};
}

TEST(LiftDrag, PushesALinkThatMoves) {
  RunningWorld world(worldWith(kWing));
  const double angle = 0.2;
  const Vector3 velocity = 10 * Vector3(std::cos(angle), 0, -std::sin(angle));
  const Vector3 expected = 0.5 * 1.2 * 100 * 3 / 2 *
                           (4 * angle * Vector3(std::sin(angle), 0, std::cos(angle)) - 0.5 * angle * velocity / 10);
  const auto [linear, angular] = accelerations(world, world.model("m").link("wing").value(), velocity);
  EXPECT_NEAR((linear - expected).norm(), 0, 1e-6 * expected.norm());
  EXPECT_NEAR(angular.norm(), 0, 1e-9);
}

TEST(LiftDrag, PushesAtTheCentreOfPressure) {
  RunningWorld world(worldWith(std::string(kWing) + "<cp>0 2 0</cp><a0>0.1</a0>"));
  const auto [linear, angular] = accelerations(world, world.model("m").link("wing").value(), {10, 0, 0});
  const double lift = 0.5 * 1.2 * 100 * 3 * 4 * 0.1, drag = lift / 8;
  EXPECT_NEAR((angular - Vector3(2 * lift, 0, 2 * drag)).norm(), 0, 1e-6 * lift);
  EXPECT_NEAR(linear.z(), lift / 2, 1e-6 * lift);
}

TEST(LiftDrag, SeesTheFlowOfALinkThatTurns) {
  RunningWorld world(worldWith(std::string(kWing) + "<cp>0 2 0</cp><a0>0.1</a0>"));
  // about -z its centre of pressure moves along x at 10 m/s
  const auto [linear, angular] = accelerations(world, world.model("m").link("wing").value(), {0, 0, 0}, {0, 0, -5});
  EXPECT_NEAR(linear.z(), 0.5 * 1.2 * 100 * 3 * 4 * 0.1 / 2, 1e-6);
}

TEST(LiftDrag, ReadsTheJointOfAFlap) {
  RunningWorld world(worldWith(std::string(kWing) + "<control_joint_name>hinge</control_joint_name>"
                                                    "<control_joint_rad_to_cl>-2</control_joint_rad_to_cl>"));
  ASSERT_TRUE(world.model("m").joint("hinge")->resetPosition(0.25));
  const auto [linear, angular] = accelerations(world, world.model("m").link("wing").value(), {10, 0, 0});
  EXPECT_NEAR(linear.z(), 0.5 * 1.2 * 100 * 3 * -0.5 / 2, 1e-6);
}

/// The same plugin by the name that it has in later releases.
std::string later(const std::string& parameters) {
  return test::replaced(test::replaced(worldWith(parameters), "ignition-gazebo-lift", "gz-sim-lift"),
                        "ignition::gazebo::", "gz::sim::");
}

TEST(LiftDrag, NeedsAFlowFromAheadInLaterReleases) {
  const auto lift = [](const std::string& text) {
    RunningWorld world(text);
    return accelerations(world, world.model("m").link("wing").value(), {-10, 0, 0}).first.norm();
  };
  const std::string parameters = std::string(kWing) + "<a0>0.1</a0>";
  EXPECT_GT(lift(worldWith(parameters)), 1);
  EXPECT_EQ(lift(later(parameters)), 0);
  EXPECT_GT(lift(later(parameters + "<reversible>true</reversible>")), 1);
}

TEST(LiftDrag, FeelsTheWindInLaterReleases) {
  const std::string parameters = std::string(kWing) + "<a0>0.1</a0>";
  RunningWorld world("<wind><linear_velocity>-10 0 0</linear_velocity></wind>" + later(parameters));
  const auto [linear, angular] = accelerations(world, world.model("m").link("wing").value(), {0, 0, 0});
  EXPECT_NEAR(linear.z(), 0.5 * 1.2 * 100 * 3 * 4 * 0.1 / 2, 1e-6);
  RunningWorld fortress("<wind><linear_velocity>-10 0 0</linear_velocity></wind>" + worldWith(parameters));
  EXPECT_EQ(accelerations(fortress, fortress.model("m").link("wing").value(), {0, 0, 0}).first.norm(), 0);
}

// the moment acts about the span, forward x upward, which is -y here
TEST(LiftDrag, TurnsALinkByItsMomentInLaterReleases) {
  const std::string parameters = std::string(kWing) +
                                 "<a0>0.1</a0><cma>0.3</cma><cm_delta>-2</cm_delta>"
                                 "<control_joint_name>hinge</control_joint_name>";
  RunningWorld world(later(parameters));
  ASSERT_TRUE(world.model("m").joint("hinge")->resetPosition(0.25));
  const auto [linear, angular] = accelerations(world, world.model("m").link("wing").value(), {10, 0, 0});
  const double expected = 0.5 * 1.2 * 100 * 3 * (0.3 * 0.1 - 2 * 0.25);
  EXPECT_NEAR((angular - Vector3(0, -expected, 0)).norm(), 0, 1e-6 * std::abs(expected));
  RunningWorld fortress(worldWith(parameters));
  EXPECT_EQ(accelerations(fortress, fortress.model("m").link("wing").value(), {10, 0, 0}).second.norm(), 0);
}

TEST(LiftDrag, FindsALinkOfANestedModel) {
  for (const char* name : {"inner::fin", "fin", "m::inner::fin"}) {
    RunningWorld world(worldWith(std::string("<link_name>") + name + "</link_name><a0>0.1</a0>"));
    const auto [linear, angular] = accelerations(world, world.model("m").link("inner::fin").value(), {10, 0, 0});
    EXPECT_GT(linear.z(), 1) << name;
  }
}

TEST(LiftDrag, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(worldWith(std::string(kWing) + "<a0>0.1</a0>"));
  world.model("m").link("wing")->setVelocity({10, 0, -1}, {0.1, 0, 0});
  world.step(100);
  const auto state = world.simulation().saveState();
  world.step(100);
  const auto hash = world.simulation().stateHash();
  ASSERT_TRUE(world.simulation().restoreState(state));
  world.step(100);
  EXPECT_EQ(world.simulation().stateHash(), hash);
}

TEST(LiftDragParameters, AreRefusedWhereTheyMakeNoSense) {
  const std::string left = "lift-drag of m is left out: ";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "no <link_name> is given"},
           {"<link_name>wings</link_name>", "<link_name> 'wings' is not a link of model 'm'"},
           {"<link_name>wing</link_name><control_joint_name>h</control_joint_name>",
            "<control_joint_name> 'h' is not a joint of model 'm'"},
           {"<link_name>wing</link_name><air_density>-1</air_density>", "<air_density> must be above zero"},
           {"<link_name>wing</link_name><area>-1</area>", "<area> must be zero or more"},
           {"<link_name>wing</link_name><forward>0 0 0</forward>", "<forward> must have a direction"},
           {"<link_name>wing</link_name><upward>2 0 0</upward>",
            "<upward> is parallel to <forward>; it must have a component across it"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{left + message});
  }
}

}  // namespace
}  // namespace pongsim::lift_drag_test
