#include "base/report/crash_report.hh"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

namespace pongsim::base {
namespace {

void crash() {
  // without a sanitizer's handler, whose report would come after ours
  std::signal(SIGABRT, SIG_DFL);
  reportCrashes();
  std::raise(SIGABRT);
}

TEST(CrashReportDeathTest, NamesThePartThatRuns) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        const RunningPart outer("the outer part", "in outer");
        { const RunningPart inner("the inner part", "in inner"); }
        crash();
      },
      testing::KilledBySignal(SIGABRT), "pongsim: error: crashed with SIGABRT in the outer part, in outer\n");
}

TEST(CrashReportDeathTest, NamesThePartOfTheThreadThatCrashes) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        const RunningPart main("the part of the main thread", "in run");
        std::thread([] {
          const CrashStack stack;
          const RunningPart other("the other part", "in other");
          crash();
        }).join();
      },
      testing::KilledBySignal(SIGABRT), "pongsim: error: crashed with SIGABRT in the other part, in other\n");
}

TEST(CrashReportDeathTest, NamesNobodyWhereNobodyRuns) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(crash(), testing::KilledBySignal(SIGABRT), "pongsim: error: crashed with SIGABRT\n");
}

}  // namespace
}  // namespace pongsim::base
