#include "plugin/system_name.hh"

#include <gtest/gtest.h>

namespace pongsim::plugin {
namespace {

TEST(SystemName, IsTheSameForAllFormsThatWorldsUse) {
  for (const char* filename :
       {"ignition-gazebo-diff-drive-system", "libignition-gazebo-diff-drive-system.so",
        "ignition-gazebo6-diff-drive-system", "libignition-gazebo6-diff-drive-system.so", "gz-sim-diff-drive-system",
        "gz-sim7-diff-drive-system", "libgz-sim-diff-drive-system.so", "pongsim-diff-drive-system",
        "libpongsim-diff-drive-system.so"}) {
    EXPECT_EQ(systemName(filename), "diff-drive") << filename;
  }
}

TEST(SystemName, IsThatOfAPluginOfLaunchFiles) {
  for (const char* filename : {"ignition-launch-websocket-server", "libignition-launch5-websocket-server.so",
                               "gz-launch-websocket-server", "gz-sim-websocket-server-system"}) {
    EXPECT_EQ(systemName(filename), "web") << filename;
  }
}

TEST(SystemName, LeavesOtherNamesAlone) {
  EXPECT_EQ(systemName("libMySystem.so"), "MySystem");
  EXPECT_EQ(systemName("my-own-system"), "my-own-system");
  EXPECT_EQ(systemName("ignition-gazebo"), "ignition-gazebo");
  EXPECT_EQ(systemName(""), "");
}

}  // namespace
}  // namespace pongsim::plugin
