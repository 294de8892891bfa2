#include "ros2/config/environment.hh"

#include <gtest/gtest.h>

#include <list>
#include <stdexcept>

#include "support/environment_variable.hh"

namespace pongsim::ros2 {
namespace {

/// All variables unset, except those that a test sets.
class EnvironmentTest : public testing::Test {
 protected:
  EnvironmentTest() {
    for (const char* name : {"ROS_DOMAIN_ID", "ROS_LOCALHOST_ONLY", "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS",
                             "PONGSIM_NETWORK", "ROS_DISCOVERY_SERVER", "RMW_IMPLEMENTATION",
                             "FASTDDS_BUILTIN_TRANSPORTS", "FASTRTPS_DEFAULT_PROFILES_FILE", "CYCLONEDDS_URI"}) {
      variables_.emplace_back(name).unset();
    }
  }
  static void set(const char* name, const char* value) { setenv(name, value, 1); }
  static std::vector<std::string> unmet() { return unmetVariables(participantOptionsOfEnvironment()); }

  std::list<test::EnvironmentVariable> variables_;
};

TEST_F(EnvironmentTest, WithoutVariablesMeetsTheNodesOfThisMachine) {
  const ParticipantOptions options = participantOptionsOfEnvironment();
  EXPECT_EQ(options.domain, 0);
  EXPECT_FALSE(options.isLoopbackOnly || options.isAlone || options.interface);
  EXPECT_TRUE(unmet().empty());
}

TEST_F(EnvironmentTest, LimitsTheRangeOfDiscovery) {
  set("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
  EXPECT_TRUE(participantOptionsOfEnvironment().isLoopbackOnly);
  EXPECT_TRUE(unmet().empty());
  set("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF");
  EXPECT_TRUE(participantOptionsOfEnvironment().isAlone);
  EXPECT_EQ(unmet(), std::vector<std::string>{"ROS_AUTOMATIC_DISCOVERY_RANGE is OFF: no node is met"});
  // as in rcl, the older variable counts where both are set
  set("ROS_LOCALHOST_ONLY", "1");
  EXPECT_TRUE(participantOptionsOfEnvironment().isLoopbackOnly);
  EXPECT_FALSE(participantOptionsOfEnvironment().isAlone);
  set("ROS_LOCALHOST_ONLY", "0");
  set("ROS_AUTOMATIC_DISCOVERY_RANGE", "FAR");
  EXPECT_THROW(participantOptionsOfEnvironment(), std::invalid_argument);
}

TEST_F(EnvironmentTest, ReadsStaticPeers) {
  set("ROS_STATIC_PEERS", "192.0.2.7;robot.example;");
  EXPECT_EQ(participantOptionsOfEnvironment().staticPeers, (std::vector<std::string>{"192.0.2.7", "robot.example"}));
  ASSERT_EQ(unmet().size(), 1U);
  EXPECT_NE(unmet()[0].find("--network"), std::string::npos);
  set("PONGSIM_NETWORK", "eth0");
  EXPECT_TRUE(unmet().empty());
}

TEST_F(EnvironmentTest, SaysWhatTheSimulationCannotDo) {
  for (const auto& [name, value] :
       {std::pair{"ROS_DISCOVERY_SERVER", "127.0.0.1:11811"}, std::pair{"FASTDDS_BUILTIN_TRANSPORTS", "LARGE_DATA"},
        std::pair{"RMW_IMPLEMENTATION", "rmw_zenoh_cpp"}, std::pair{"FASTRTPS_DEFAULT_PROFILES_FILE", "/a.xml"},
        std::pair{"CYCLONEDDS_URI", "file:///a.xml"}}) {
    set(name, value);
    ASSERT_EQ(unmet().size(), 1U) << name;
    EXPECT_TRUE(unmet()[0].starts_with(name)) << unmet()[0];
    unsetenv(name);
  }
}

TEST_F(EnvironmentTest, IsSilentAboutWhatItHas) {
  set("FASTDDS_BUILTIN_TRANSPORTS", "UDPv4");
  set("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp");
  EXPECT_TRUE(unmet().empty());
}

}  // namespace
}  // namespace pongsim::ros2
