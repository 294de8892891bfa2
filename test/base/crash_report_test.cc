#include "base/crash_report.hh"

#include <gtest/gtest.h>

#include <csignal>

namespace pongsim::base {
namespace {

void crash() {
  // a sanitizer's report would only make it longer
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

TEST(CrashReportDeathTest, NamesNobodyWhereNobodyRuns) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(crash(), testing::KilledBySignal(SIGABRT), "pongsim: error: crashed with SIGABRT\n");
}

}  // namespace
}  // namespace pongsim::base
