#include "cli/stop_signal.hh"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

#include "support/process.hh"

namespace pongsim::cli {
namespace {

void waitForStop(const StopSignal& signal) {
  const auto deadline = std::chrono::steady_clock::now() + test::kDeadline;
  while (!signal.stopped() && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  ASSERT_TRUE(signal.stopped());
}

TEST(StopSignal, TellsOfEitherSignal) {
  for (int number : {SIGINT, SIGTERM}) {
    StopSignal signal;
    EXPECT_FALSE(signal.stopped());
    std::promise<void> told;
    const StopSignal::Callback tell(signal, [&told] { told.set_value(); });
    kill(getpid(), number);
    EXPECT_EQ(told.get_future().wait_for(test::kDeadline), std::future_status::ready);
    EXPECT_TRUE(signal.stopped());
  }
}

TEST(StopSignal, TellsAtOnceWhereItHasComeBefore) {
  StopSignal signal;
  kill(getpid(), SIGTERM);
  waitForStop(signal);
  bool told = false;
  const StopSignal::Callback tell(signal, [&told] { told = true; });
  EXPECT_TRUE(told);
}

// as when a run fails, and what the callback uses is destroyed before the signal
TEST(StopSignal, CallsNobodyAfterTheWorkHasThrown) {
  StopSignal signal;
  std::atomic<bool> isCalled = false;
  try {
    const StopSignal::Callback call(signal, [&isCalled] { isCalled = true; });
    throw std::runtime_error("the work failed");
  } catch (const std::runtime_error&) {
  }
  kill(getpid(), SIGTERM);
  waitForStop(signal);
  // its thread calls under the same mutex, so that it is done with this signal now
  const StopSignal::Callback later(signal, [] {});
  EXPECT_FALSE(isCalled);
}

TEST(StopSignalDeathTest, EndsTheProcessAtTheSecondSignal) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        StopSignal signal;
        std::promise<void> first;
        const StopSignal::Callback tell(signal, [&first] { first.set_value(); });
        kill(getpid(), SIGINT);
        first.get_future().wait();
        kill(getpid(), SIGINT);
        pause();
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace pongsim::cli
