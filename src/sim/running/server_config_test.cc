#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "pongsim/simulation.hh"
#include "support/temp_folder.hh"

namespace pongsim {
namespace {

constexpr const char* kPhysics =
    "<plugin entity_name='*' entity_type='world' filename='ignition-gazebo-physics-system' "
    "name='ignition::gazebo::systems::Physics'/>";

/// Sets the variable to a server config file, for a world with a falling ball.
class ServerConfig : public testing::Test {
 protected:
  ~ServerConfig() override {
    unsetenv("IGN_GAZEBO_SERVER_CONFIG_PATH");
    unsetenv("GZ_SIM_SERVER_CONFIG_PATH");
  }

  void write(const std::string& plugins, const char* variable = "IGN_GAZEBO_SERVER_CONFIG_PATH") {
    const auto file =
        folder_.write("server.config", "<server_config><plugins>" + plugins + "</plugins></server_config>");
    setenv(variable, file.c_str(), 1);
  }

  /// @return Whether the ball has fallen after 10 steps.
  bool falls(const std::string& plugins = "") {
    const std::string text = "<sdf version='1.9'><world name='w'>" + plugins +
                             "<model name='ball'><pose>0 0 9 0 0 0</pose><link name='l'/></model></world></sdf>";
    const auto simulation = Simulation::fromText(text, "world.sdf", {}, diagnostics_);
    if (simulation == nullptr) return false;
    simulation->step(10);
    return simulation->world().model("ball")->pose().position.z() < 9;
  }

  std::string firstMessage() const { return diagnostics_.all().empty() ? "" : diagnostics_.all().front().message; }

  test::TempFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(ServerConfig, GivesTheSystemsOfAWorldThatListsNone) {
  write(kPhysics);
  EXPECT_TRUE(falls());
  EXPECT_EQ(firstMessage(), "");
}

TEST_F(ServerConfig, IsFoundByTheNewerVariableToo) {
  write(kPhysics, "GZ_SIM_SERVER_CONFIG_PATH");
  EXPECT_TRUE(falls());
}

TEST_F(ServerConfig, TakesThePlaceOfTheDefaultSystems) {
  write(
      "<plugin entity_name='*' entity_type='world' filename='ignition-gazebo-scene-broadcaster-system' "
      "name='ignition::gazebo::systems::SceneBroadcaster'/>");
  EXPECT_FALSE(falls());
  EXPECT_EQ(firstMessage(), "the server config file has no physics for world 'w': nothing will move");
}

TEST_F(ServerConfig, DoesNothingToAWorldThatListsSystems) {
  write("");
  EXPECT_TRUE(falls("<plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>"));
  EXPECT_EQ(firstMessage(), "");
}

TEST_F(ServerConfig, IsForTheWorldThatItNames) {
  std::string other = kPhysics;
  other.replace(other.find('*'), 1, "other");
  write(other);
  EXPECT_FALSE(falls());
}

TEST_F(ServerConfig, GivesSystemsToModels) {
  const std::string text =
      "<plugin entity_name='ball' entity_type='model' filename='ignition-gazebo-no-such-system' name='x'/>";
  write(kPhysics + text);
  falls();
  EXPECT_NE(firstMessage().find("no-such"), std::string::npos) << firstMessage();
}

TEST_F(ServerConfig, SaysWhatItHasNoUseFor) {
  write(std::string(kPhysics) + "<plugin entity_name='cube' entity_type='model' filename='f' name='n'/>");
  EXPECT_TRUE(falls());
  EXPECT_EQ(firstMessage(), "world 'w' has no model 'cube': its system is left out");
  diagnostics_ = Diagnostics();
  write(std::string(kPhysics) + "<plugin entity_name='w::ball::l::s' entity_type='sensor' filename='f' name='n'/>");
  EXPECT_TRUE(falls());
  EXPECT_TRUE(firstMessage().starts_with("a system for the sensor 'w::ball::l::s' is left out")) << firstMessage();
  diagnostics_ = Diagnostics();
  write(std::string(kPhysics) + "<plugin entity_type='world' filename='f' name='n'/>");
  EXPECT_TRUE(falls());
  EXPECT_EQ(firstMessage(), "<plugin> of the server config file has no entity_name; left out");
}

TEST_F(ServerConfig, LeavesAWorldWithoutSystemsWhereItIsNotThere) {
  setenv("IGN_GAZEBO_SERVER_CONFIG_PATH", "/no/such.config", 1);
  EXPECT_FALSE(falls());
  EXPECT_EQ(firstMessage(), "there is no file '/no/such.config': no system is loaded");
  diagnostics_ = Diagnostics();
  write("");
  EXPECT_FALSE(falls());
  EXPECT_EQ(firstMessage(), "the server config file has no <plugin> in a <plugins>: no system is loaded");
}

TEST_F(ServerConfig, IsAnErrorWhereItIsNoXml) {
  setenv("IGN_GAZEBO_SERVER_CONFIG_PATH", folder_.write("server.config", "<server_config>").c_str(), 1);
  EXPECT_FALSE(falls());
  EXPECT_TRUE(diagnostics_.hasErrors());
}

}  // namespace
}  // namespace pongsim
