#include "cli/look_around.hh"

#include <gtest/gtest.h>
#include <signal.h>

#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::cli {
namespace {

TEST(LookAround, WarnsOfAProcessThatDoesNotAnswer) {
  test::testDomain();
  test::Process other({TRANSPORT_PEER, "offer", "3", "2"});
  ASSERT_TRUE(other.waitForOutput("ready"));
  other.kill(SIGSTOP);
  Transport transport;
  for (int look = 0; look < 2; ++look) {
    testing::internal::CaptureStderr();
    const std::size_t found = look == 0 ? topicsAround(transport).size() : servicesAround(transport).size();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("a process in this DDS domain does not answer"),
              std::string::npos);
    EXPECT_EQ(found, 0);
  }

  other.kill(SIGCONT);
  ASSERT_TRUE(test::waitUntil([&] { return servicesAround(transport).size() == 2; }));
  testing::internal::CaptureStderr();
  EXPECT_EQ(topicsAround(transport).size(), 3);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pongsim::cli
