#include "sim/diagnostic_log.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace pongsim::sim {
namespace {

TEST(DiagnosticLog, TellsAllAndReturnsTheFirstErrorInALine) {
  Diagnostics diagnostics;
  const auto file = std::make_shared<const std::string>("a.sdf");
  diagnostics.warning({file, 1, 2}, "this is odd");
  diagnostics.error({file, 3, 4}, "this is wrong", "mend it");
  diagnostics.error({file, 5, 6}, "this too");
  testing::internal::CaptureStderr();
  const std::string first = logDiagnostics(diagnostics, Logger("run"));
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(first, "a.sdf:3:4: this is wrong");
  for (const char* part : {"warning: run: a.sdf:1:2: this is odd", "error: run: a.sdf:3:4: this is wrong", "mend it",
                           "error: run: a.sdf:5:6: this too"}) {
    EXPECT_NE(told.find(part), std::string::npos) << told;
  }
}

TEST(DiagnosticLog, IsNotFilledByOneRequest) {
  Diagnostics diagnostics;
  for (int i = 0; i < 60'000; ++i) diagnostics.warning({}, "odd " + std::to_string(i));
  diagnostics.error({}, "this is wrong");
  testing::internal::CaptureStderr();
  EXPECT_EQ(logDiagnostics(diagnostics, Logger("run")), "this is wrong");
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(told, '\n'), 21);
  EXPECT_NE(told.find("odd 19\n"), std::string::npos);
  EXPECT_NE(told.find("and 59981 more errors and warnings"), std::string::npos) << told;
}

TEST(DiagnosticLog, SaysNothingOfNothing) { EXPECT_EQ(logDiagnostics({}, Logger("run")), ""); }

}  // namespace
}  // namespace pongsim::sim
