#include "ign/library.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "support/ign/discovery_packet.hh"
#include "support/process.hh"

namespace pongsim::ign {
namespace {

TEST(Library, IsThereOnce) {
  setenv("IGN_IP", "127.0.0.1", 1);
  EXPECT_EQ(&library(), ignition::transport::NodeShared::Instance());
  EXPECT_EQ(&library(), &library());
}

TEST(Library, EndsWithItsProcessWhateverIsSaidMeanwhile) {
  // many short processes exit while discovery packets arrive from the others; the port is used by this test only
  const int port = 20'000 + getpid() % 20'000;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  std::atomic<bool> mustEnd = false;
  std::thread crowd([&] {
    const std::string comes = packetOf("somebody", ignition::msgs::Discovery::NEW_CONNECTION);
    const std::string goes = packetOf("somebody", ignition::msgs::Discovery::END_CONNECTION);
    while (!mustEnd) {
      sayToGroup(comes, "239.255.0.7", port);
      sayToGroup(goes, "239.255.0.7", port);
    }
  });
  for (int i = 0; i < 10; ++i) {
    test::Process process({self, "--gtest_filter=Library.IsThereOnce"},
                          {.environment = {{"IGN_DISCOVERY_MSG_PORT", std::to_string(port)},
                                           {"IGN_DISCOVERY_SRV_PORT", std::to_string(port + 1)}},
                           .folder = {}});
    EXPECT_EQ(process.wait(), 0) << process.output() << process.error();
  }
  mustEnd = true;
  crowd.join();
}

}  // namespace
}  // namespace pongsim::ign
