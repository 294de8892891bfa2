#include "ros2/wire/security.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

class RosSecurity : public testing::Test {
 protected:
  RosSecurity() { clear(); }
  ~RosSecurity() override { clear(); }

  static void clear() {
    for (const char* name : {"ROS_SECURITY_ENABLE", "ROS_SECURITY_KEYSTORE", "ROS_SECURITY_ENCLAVE_OVERRIDE",
                             "ROS_SECURITY_STRATEGY", "PONGSIM_SECURITY"}) {
      unsetenv(name);
    }
  }
  static std::string refusal() {
    try {
      securityOfEnvironment(0);
    } catch (const KeystoreError& error) {
      return error.what();
    }
    return "";
  }

  test::TempFolder folder_;
};

TEST_F(RosSecurity, IsNoneUnlessAskedFor) {
  EXPECT_FALSE(securityOfEnvironment(0).identity);
  setenv("ROS_SECURITY_KEYSTORE", "/no/such/folder", 1);
  EXPECT_FALSE(securityOfEnvironment(0).identity);
  EXPECT_EQ(securityOfEnvironment(0).warning, "");
}

TEST_F(RosSecurity, IsOurOwnWhereRosSaysNothing) {
  setenv("PONGSIM_SECURITY", "/no/such/folder", 1);
  EXPECT_EQ(refusal(), "there is no keystore at '/no/such/folder'");
  setenv("ROS_SECURITY_ENABLE", "false", 1);
  EXPECT_EQ(securityOfEnvironment(0).warning, "ROS_SECURITY_ENABLE is 'false': ROS nodes are not secured");
}

TEST_F(RosSecurity, RefusesAnEnclaveThatIsNotThereWhereItIsEnforced) {
  std::filesystem::create_directories(folder_.path() / "enclaves/talker");
  setenv("ROS_SECURITY_ENABLE", "true", 1);
  EXPECT_EQ(refusal(), "ROS_SECURITY_ENABLE is true, but ROS_SECURITY_KEYSTORE is not set");
  setenv("ROS_SECURITY_KEYSTORE", folder_.path().c_str(), 1);
  setenv("ROS_SECURITY_ENCLAVE_OVERRIDE", "/listener", 1);
  const std::string missing = "keystore '" + folder_.path().string() + "' has no enclave '/listener'";
  EXPECT_EQ(securityOfEnvironment(0).warning,
            missing + ", and ROS_SECURITY_STRATEGY is not Enforce: ROS nodes are not secured");
  setenv("ROS_SECURITY_STRATEGY", "Enforce", 1);
  EXPECT_TRUE(refusal().starts_with(missing));
}

}  // namespace
}  // namespace pongsim::ros2
