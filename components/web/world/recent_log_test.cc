#include "web/world/recent_log.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::web {
namespace {

TEST(RecentLog, TellsWarningsAndErrorsAsTheyComeAndThoseBefore) {
  const Logger logger("tests");
  RecentLog log;
  logger.warning("one");
  std::vector<std::string> seen;
  auto watch = log.watch([&](const RecentLog::Line& line) {
    seen.push_back(line.speaker + (line.level == LogLevel::kError ? "! " : ": ") + line.message);
  });
  logger.info("not this");
  logger.error("two");
  EXPECT_EQ(seen, (std::vector<std::string>{"tests: one", "tests! two"}));
  watch.reset();
  logger.warning("three");
  EXPECT_EQ(seen.size(), 2U);
}

TEST(RecentLog, IsBounded) {
  const Logger logger("tests");
  RecentLog log;
  for (std::size_t i = 0; i < RecentLog::kKept + 20; ++i) logger.warning(std::to_string(i));
  logger.warning(std::string(1'000'000, 'x'));
  std::vector<RecentLog::Line> seen;
  const auto watch = log.watch([&](const RecentLog::Line& line) { seen.push_back(line); });
  ASSERT_EQ(seen.size(), RecentLog::kKept);
  EXPECT_EQ(seen.front().message, "21");
  EXPECT_EQ(seen.back().message.size(), RecentLog::kLongest);
}

}  // namespace
}  // namespace pongsim::web
