#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/wind.pb.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/fortress_worlds.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::wind_effects_test {
namespace {

using test::RunningWorld;

/// A world without gravity in which the wind blows, with what else stands in it.
std::string windy(const std::string& parameters, const std::string& rest, const std::string& wind = "5 0 0") {
  return "<gravity>0 0 0</gravity><wind><linear_velocity>" + wind +
         "</linear_velocity></wind><plugin filename='ignition-gazebo-wind-effects-system' "
         "name='ignition::gazebo::systems::WindEffects'>" +
         parameters + "</plugin>" + rest;
}

constexpr const char* kAtOnce =
    "<horizontal><magnitude><time_for_rise>0.001</time_for_rise></magnitude><direction><time_for_rise>0.001"
    "</time_for_rise></direction></horizontal><vertical><time_for_rise>0.001</time_for_rise></vertical>";

/// @param parts Of the link, before its mass of 2 kg.
std::string box(const std::string& name, const std::string& model, const std::string& parts = {}) {
  return "<model name='" + name + "'>" + model + "<link name='link'>" + parts +
         "<inertial><pose>0 0.5 0 0 0 0</pose><mass>2</mass></inertial></link></model>";
}
constexpr const char* kInWind = "<enable_wind>true</enable_wind>";

Vector3 velocityOf(RunningWorld& world, const std::string& model) {
  return world.model(model).links().front().linearVelocity();
}

ignition::msgs::Wind wind(const Vector3& velocity, bool blows) {
  ignition::msgs::Wind message;
  message.mutable_linear_velocity()->set_x(velocity.x());
  message.mutable_linear_velocity()->set_y(velocity.y());
  message.mutable_linear_velocity()->set_z(velocity.z());
  message.set_enable_wind(blows);
  return message;
}

TEST(WindEffects, CarriesALinkAwayToItsOwnVelocity) {
  // turning would change what the link's origin does
  const std::string held =
      "<joint name='rail' type='prismatic'><parent>world</parent><child>link</child>"
      "<axis><xyz>1 0 0</xyz></axis></joint>";
  RunningWorld world(
      windy("<force_approximation_scaling_factor>0.5</force_approximation_scaling_factor>" + std::string(kAtOnce),
            box("m", kInWind + held)));
  // m v' = m s (w - v)
  world.step(2000);
  EXPECT_NEAR(velocityOf(world, "m").x(), 5 * (1 - std::exp(-0.5 * 2)), 1e-3);
  // the end of it: the wind's velocity
  world.step(30000);
  EXPECT_NEAR(velocityOf(world, "m").x(), 5, 1e-5);
}

TEST(WindEffects, PushesByRegionIfItIsTold) {
  const std::string field =
      "<force_approximation_scaling_factor><when zgt='0' zlt='5'>0.2</when><when zge='5'><k>0.5</k><rz>0 0 0.1 0</rz>"
      "</when></force_approximation_scaling_factor>";
  const auto at = [](const std::string& name, const std::string& height) {
    return "<model name='" + name + "'><pose>0 0 " + height + " 0 0 0</pose>" + kInWind +
           "<link name='link'><inertial><mass>2</mass></inertial></link></model>";
  };
  RunningWorld world(windy(field + kAtOnce, at("diver", "-1") + at("sailor", "1") + at("bird", "10")));
  world.step(100);
  EXPECT_EQ(velocityOf(world, "diver").norm(), 0);
  EXPECT_NEAR(velocityOf(world, "sailor").x(), 5 * (1 - std::exp(-0.2 * 0.1)), 1e-3);
  EXPECT_NEAR(velocityOf(world, "bird").x(), 5 * (1 - std::exp(-0.5 * 0.1)), 1e-3);
}

TEST(WindEffects, PushesAtTheCentreOfMass) {
  RunningWorld world(windy(kAtOnce, box("m", kInWind)));
  world.step(100);
  EXPECT_NEAR(velocityOf(world, "m").x(), 5 * (1 - std::exp(-0.1)), 1e-3);
  EXPECT_NEAR(world.model("m").link("link")->angularVelocity().norm(), 0, 1e-9);
}

TEST(WindEffects, RisesAndFallsAsItIsTold) {
  RunningWorld world(windy("<horizontal><magnitude><time_for_rise>0.5</time_for_rise></magnitude></horizontal>",
                           box("m", ""), "0 4 2"));
  EXPECT_EQ(world.simulation().world().wind(), Vector3(0, 4, 2));
  world.step(1000);
  const Vector3 risen = world.simulation().world().wind();
  EXPECT_NEAR((risen - Vector3(0, 4 * (1 - std::exp(-2)), 2 * (1 - std::exp(-1)))).norm(), 0, 3e-3);
  world.tell("/world/w/wind", wind({0, 1, 0}, true));
  world.step(500);
  const double fallen = 1 + (risen.y() - 1) * std::exp(-1);
  EXPECT_NEAR(world.simulation().world().wind().y(), fallen, 3e-3);
}

TEST(WindEffects, MovesTheLinksThatAreInIt) {
  const std::string out = "<enable_wind>false</enable_wind>";
  RunningWorld world(windy(
      kAtOnce, box("by_model", kInWind) + box("by_link", "", kInWind) + box("not", "") + box("by_both", kInWind, out) +
                   box("fixed", std::string(kInWind) + "<static>true</static>") + "<model name='outer'>" + kInWind +
                   "<link name='link'><inertial><mass>2</mass></inertial></link>" + box("inner", "") + "</model>"));
  world.step(100);
  for (const char* name : {"by_model", "by_link", "by_both", "outer"}) {
    EXPECT_GT(velocityOf(world, name).x(), 0.4) << name;
  }
  for (const char* name : {"not", "fixed", "outer::inner"}) {
    EXPECT_EQ(velocityOf(world, name).norm(), 0) << name;
  }
}

TEST(WindEffects, MovesWhatComesLater) {
  RunningWorld world(windy(kAtOnce, box("m", kInWind)));
  world.step(10);
  Diagnostics diagnostics;
  const std::string text = "<sdf version='1.9'>" + box("late", kInWind) + "</sdf>";
  ASSERT_TRUE(world.simulation().insertText(text, "late.sdf", {}, diagnostics));
  world.step(100);
  EXPECT_GT(velocityOf(world, "late").x(), 0.4);
  ASSERT_TRUE(world.simulation().remove(world.model("m")));
  world.step(100);
  EXPECT_GT(velocityOf(world, "late").x(), 0.8);
}

TEST(WindEffects, IsSwitchedOffAndOn) {
  RunningWorld world(windy(kAtOnce, box("m", kInWind)));
  world.tell("/world/w/wind", wind({5, 0, 0}, false));
  world.step(100);
  EXPECT_EQ(velocityOf(world, "m"), Vector3::Zero());
  world.tell("/world/w/wind", wind({0, -5, 0}, true));
  world.step(100);
  EXPECT_LT(velocityOf(world, "m").y(), -0.4);
  const Vector3 before = velocityOf(world, "m");
  for (int i = 0; i < 20; ++i) world.simulation().stepPaused();
  EXPECT_EQ(velocityOf(world, "m"), before);
}

TEST(WindEffects, TellsWhatItWasTold) {
  RunningWorld world(windy("", box("m", kInWind), "1 2 3"));
  const auto ask = [&] {
    ignition::msgs::Wind reply;
    const CallResult result =
        test::askService(world.simulation().transport(), "/world/w/wind_info", ignition::msgs::Empty(), reply);
    EXPECT_TRUE(result) << result.error;
    return reply.SerializeAsString();
  };
  EXPECT_EQ(ask(), wind({1, 2, 3}, true).SerializeAsString());
  world.tell("/world/w/wind", wind({0, 1, 0}, false));
  world.step(1);
  EXPECT_EQ(ask(), wind({0, 1, 0}, false).SerializeAsString());
}

TEST(WindEffects, IgnoresWindThatIsNone) {
  RunningWorld world(windy(kAtOnce, box("m", kInWind)));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double speed : {1e6, 1e308, -infinity, std::nan("")}) {
    world.tell("/world/w/wind", wind({speed, 0, speed}, true));
    world.step(10);
    EXPECT_EQ(world.simulation().world().wind(), Vector3(5, 0, 0)) << speed;
  }
}

// a force that overshoots would run away
TEST(WindEffects, StaysCalmWhateverItsScale) {
  RunningWorld world(
      windy("<force_approximation_scaling_factor>1e9</force_approximation_scaling_factor>" + std::string(kAtOnce),
            box("m", kInWind)));
  world.step(1000);
  EXPECT_NEAR((velocityOf(world, "m") - Vector3(5, 0, 0)).norm(), 0, 1e-6);
}

constexpr const char* kNoisy =
    "<horizontal><magnitude><noise type='gaussian'><mean>0</mean><stddev>1</stddev></noise></magnitude></horizontal>";

TEST(WindEffects, StartsAnewAfterAReset) {
  RunningWorld world(windy(kNoisy, box("m", kInWind)));
  world.step(300);
  const std::uint64_t hash = world.simulation().stateHash();
  world.tell("/world/w/wind", wind({0, 1, 0}, false));
  world.step(10);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(300);
  EXPECT_EQ(world.simulation().stateHash(), hash);
}

TEST(WindEffects, GoesOnFromASavedState) {
  RunningWorld world(windy(kNoisy, box("m", kInWind)));
  world.tell("/world/w/wind", wind({0, 3, 1}, true));
  world.step(200);
  RunningWorld other(windy(kNoisy, box("m", kInWind)));
  test::expectSameBitsFromSavedState(world, other, 200);
}

TEST(WindEffects, SaysWhatIsWrongWithIt) {
  const std::string left = "wind-effects is left out: ";
  const std::array<std::array<std::string, 2>, 5> cases{{
      {"<force_approximation_scaling_factor>0</force_approximation_scaling_factor>",
       left + "<force_approximation_scaling_factor> must be at least 1e-06"},
      {"<force_approximation_scaling_factor>-1</force_approximation_scaling_factor>",
       left + "<force_approximation_scaling_factor> must be at least 1e-06"},
      {"<horizontal><magnitude><time_for_rise>0</time_for_rise></magnitude></horizontal>",
       left + "<time_for_rise> must be at least 1e-06"},
      {"<vertical><noise type='uniform'/></vertical>", left + "<noise> has the unknown type 'uniform'"},
      {"<vertikal/>", "wind-effects does not know <vertikal>"},
  }};
  for (const auto& [parameters, expected] : cases) {
    EXPECT_EQ(RunningWorld::complaintsAbout(windy(parameters, "")), std::vector<std::string>{expected}) << parameters;
  }
}

// As Fortress's test of the same name.
TEST(WindEffects, WindForce) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "Fortress's worlds are not here";
  RunningWorld world(*worlds / "test/wind_effects.sdf");
  world.step(3000);
  double lastGain = std::numeric_limits<double>::infinity();
  Vector3 last = velocityOf(world, "wind_test1");
  for (int i = 0; i < 3000; ++i) {
    world.step(1);
    const Vector3 now = velocityOf(world, "wind_test1");
    const double gain = (now - last).norm() / 1e-3;
    EXPECT_LT(1e-6, lastGain - gain) << i;
    lastGain = gain;
    last = now;
  }
}

}  // namespace
}  // namespace pongsim::wind_effects_test
