#include "ros2/wire/participant.hh"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

using test::Process;

bool becomesTrue(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + test::kDeadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Whoever is killed is forgotten when its lease ends, and whoever lives is not.
void forgetsTheKilled() {
  const int domain = test::testDomain();
  Participant participant({.domain = domain});
  std::vector<std::unique_ptr<Process>> others;
  const auto knows = [&](std::size_t count) {
    return becomesTrue([&] { return participant.graph().participants().size() == count; });
  };
  const Process::Options options{.environment = {{"ROS_DOMAIN_ID", std::to_string(domain)}}, .folder = {}};
  for (std::size_t i = 1; i <= 3; ++i) {
    others.push_back(std::make_unique<Process>(std::vector<std::string>{PONGSIM_PROGRAM, "run", "--ros2"}, options));
    ASSERT_TRUE(knows(i));
  }
  for (int i = 0; i < 2; ++i) {
    others[i]->kill(SIGKILL);
    others[i]->wait();
  }
  EXPECT_TRUE(knows(1));
  others[2]->kill(SIGSTOP);
  EXPECT_TRUE(knows(0));
  EXPECT_TRUE(participant.graph().endpoints().empty());
  others[2]->kill(SIGCONT);
  EXPECT_TRUE(knows(1)) << "it is back";
  EXPECT_TRUE(becomesTrue([&] { return !participant.graph().endpoints().empty(); }));
  others[2]->kill(SIGINT);
  EXPECT_TRUE(knows(0)) << "it has said goodbye";
}

TEST(Participant, ForgetsWhoWasKilled) { forgetsTheKilled(); }

TEST(Participant, ForgetsWhoWasKilledOfASecuredDomain) {
  const test::TempFolder folder;
  const std::string keys = folder.path() / "keys";
  Process security({PONGSIM_PROGRAM, "security", "init", keys});
  ASSERT_EQ(security.wait(), 0) << security.error();
  setenv("PONGSIM_SECURITY", keys.c_str(), 1);
  forgetsTheKilled();
  unsetenv("PONGSIM_SECURITY");
}

}  // namespace
}  // namespace pongsim::ros2
