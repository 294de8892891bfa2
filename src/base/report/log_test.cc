#include "pongsim/log.hh"

#include <gtest/gtest.h>

namespace pongsim {
namespace {

class LogTest : public testing::TestWithParam<LogLevel> {
 protected:
  ~LogTest() override { setLogLevel(LogLevel::kWarning); }
};

TEST_P(LogTest, SaysWhatItsLevelLetsThrough) {
  setLogLevel(GetParam());
  EXPECT_EQ(logLevel(), GetParam());
  testing::internal::CaptureStderr();
  const Logger log("diff-drive of robot");
  log.error("e");
  log.warning("w");
  log.info("i");
  log.debug("d");
  const std::string lines[] = {"error: diff-drive of robot: e\n", "warning: diff-drive of robot: w\n",
                               "info: diff-drive of robot: i\n", "debug: diff-drive of robot: d\n"};
  std::string expected;
  for (int i = 0; i < static_cast<int>(GetParam()); ++i) expected += lines[i];
  EXPECT_EQ(testing::internal::GetCapturedStderr(), expected);
}

INSTANTIATE_TEST_SUITE_P(AllLevels, LogTest,
                         testing::Values(LogLevel::kNone, LogLevel::kError, LogLevel::kWarning, LogLevel::kInfo,
                                         LogLevel::kDebug));

}  // namespace
}  // namespace pongsim
