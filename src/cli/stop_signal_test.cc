#include "cli/stop_signal.hh"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <future>

#include "support/process.hh"

namespace pongsim::cli {
namespace {

TEST(StopSignal, TellsOfEitherSignal) {
  for (int number : {SIGINT, SIGTERM}) {
    StopSignal signal;
    EXPECT_FALSE(signal.stopped());
    std::promise<void> told;
    signal.onStop([&told] { told.set_value(); });
    kill(getpid(), number);
    EXPECT_EQ(told.get_future().wait_for(test::kDeadline), std::future_status::ready);
    EXPECT_TRUE(signal.stopped());
    signal.onStop({});
  }
}

TEST(StopSignal, TellsAtOnceWhereItHasComeBefore) {
  StopSignal signal;
  std::promise<void> came;
  signal.onStop([&came] { came.set_value(); });
  kill(getpid(), SIGTERM);
  ASSERT_EQ(came.get_future().wait_for(test::kDeadline), std::future_status::ready);
  bool told = false;
  signal.onStop([&told] { told = true; });
  EXPECT_TRUE(told);
  signal.onStop({});
}

TEST(StopSignalDeathTest, EndsTheProcessAtTheSecondSignal) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        StopSignal signal;
        std::promise<void> first;
        signal.onStop([&first] { first.set_value(); });
        kill(getpid(), SIGINT);
        first.get_future().wait();
        kill(getpid(), SIGINT);
        pause();
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace pongsim::cli
