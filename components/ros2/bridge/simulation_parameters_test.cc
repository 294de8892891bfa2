#include "ros2/bridge/simulation_parameters.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <memory>
#include <optional>

#include "pongsim/simulation.hh"
#include "ros2/pairs/pairs.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

class SimulationParametersTest : public testing::Test {
 protected:
  SimulationParametersTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        R"(<sdf version="1.9"><world name="w"><physics name="p" type="ode"><real_time_factor>2</real_time_factor>
           </physics></world></sdf>)",
        "w.sdf", {}, diagnostics);
    settings_.frames.prefix = "robot/";
    TopicRule rule;
    rule.ros = "/chat";
    rule.ignition = "/other";
    rule.pair = defaultPair("ignition.msgs.StringMsg");
    rule.toRos.isReliable = false;
    rule.toRos.depth = 3;
    settings_.rules.push_back(rule);
    bridge_.emplace(simulation_->transport().node(), node_, settings_);
    all_.emplace(node_, simulation_->world(), *bridge_, settings_);
  }
  Parameters::Value get(const std::string& name) {
    const auto values = all_->parameters().get({name});
    return values.empty() ? Parameters::Value() : values[0];
  }
  bool set(const std::string& name, const Parameters::Value& value) {
    return all_->parameters().set({{name, value}}).at(0).successful;
  }

  Settings settings_;
  std::unique_ptr<Simulation> simulation_;
  Participant participant_{{.domain = test::testDomain()}};
  RosNode node_{participant_, {}};
  std::optional<Bridge> bridge_;
  std::optional<SimulationParameters> all_;
};

TEST_F(SimulationParametersTest, TheRealTimeFactorFollowsBothWays) {
  EXPECT_EQ(get("real_time_factor"), parameterOf(2.0));
  EXPECT_TRUE(set("real_time_factor", parameterOf(0.0)));
  EXPECT_EQ(simulation_->realTimeFactor(), 0);
  EXPECT_FALSE(set("real_time_factor", parameterOf(-1.0)));
  EXPECT_FALSE(set("real_time_factor", parameterOf(std::int64_t{1})));
  simulation_->setRealTimeFactor(3);
  all_->preUpdate(Time{0});
  EXPECT_EQ(get("real_time_factor"), parameterOf(3.0));
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  all_->preUpdate(Time{0});
  EXPECT_EQ(get("real_time_factor"), parameterOf(2.0));
}

TEST_F(SimulationParametersTest, ATopicIsBridgedWhereBridgeAllSaysSo) {
  Publisher publisher = simulation_->transport().node().advertise<ignition::msgs::StringMsg>("/chatter");
  const auto isBridged = [this] {
    bridge_->update();
    for (const Bridge::Topic& topic : bridge_->topics()) {
      if (topic.ros == "/chatter") return topic.isToRos;
    }
    return false;
  };
  EXPECT_TRUE(isBridged());
  EXPECT_TRUE(set("bridge_all", parameterOf(false)));
  EXPECT_FALSE(isBridged());
  EXPECT_TRUE(set("bridge_all", parameterOf(true)));
  EXPECT_TRUE(isBridged());
}

TEST_F(SimulationParametersTest, WhatItWasStartedWithIsToReadOnly) {
  for (const char* name :
       {"use_sim_time", "domain", "distro", "localhost_only", "network", "namespace", "frame_prefix", "config_file"}) {
    const auto value = get(name);
    EXPECT_NE(value.type, rcl_interfaces::ParameterType::kParameterNotSet) << name;
    EXPECT_FALSE(set(name, value)) << name;
    EXPECT_TRUE(all_->parameters().describe({name}).at(0).read_only) << name;
  }
  EXPECT_EQ(get("use_sim_time"), parameterOf(true));
  EXPECT_EQ(get("frame_prefix"), parameterOf(std::string("robot/")));
  EXPECT_EQ(get("qos_overrides./chat.publisher.reliability"), parameterOf(std::string("best_effort")));
  EXPECT_EQ(get("qos_overrides./chat.publisher.depth"), parameterOf(std::int64_t{3}));
  EXPECT_EQ(get("qos_overrides./chat.subscription.depth"), Parameters::Value());
  EXPECT_EQ(get("qos_overrides./parameter_events.publisher.depth"), parameterOf(std::int64_t{1000}));
}

}  // namespace
}  // namespace pongsim::ros2
