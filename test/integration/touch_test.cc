// A message that is published only once reaches other processes.

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {
namespace {

TEST(Touch, IsToldToOtherProcesses) {
  const auto world = start({"run", (projectFolder() / "plugins/sensors/touchplugin/touch_plugin.sdf").string()});
  const auto echo = start({"topic", "-e", "-t", "/plate/touched", "-n", "1"});
  // until the echo has been discovered
  std::optional<int> ended;
  for (int i = 0; i < 60 && !ended; ++i) {
    runToEnd({"service", "-s", "/plate/enable", "--reqtype", "Boolean", "--reptype", "Empty", "-r", "data: true",
              "--timeout", "60000"});
    ended = echo->wait(std::chrono::seconds(2));
  }
  EXPECT_EQ(ended, 0) << world->error();
  EXPECT_EQ(echo->output(), "data: true\n\n");
}

}  // namespace
}  // namespace pongsim::test
