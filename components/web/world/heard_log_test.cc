#include "web/world/heard_log.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::web {
namespace {

TEST(HeardLog, TellsWarningsAndErrorsAsTheyComeAndThoseBefore) {
  const Logger speaker("tests");
  HeardLog log;
  speaker.warning("one");
  std::vector<std::string> heard;
  auto watch = log.watch([&](const HeardLog::Entry& entry) {
    heard.push_back(entry.speaker + (entry.level == LogLevel::kError ? "! " : ": ") + entry.message);
  });
  speaker.info("not this");
  speaker.error("two");
  EXPECT_EQ(heard, (std::vector<std::string>{"tests: one", "tests! two"}));
  watch.reset();
  speaker.warning("three");
  EXPECT_EQ(heard.size(), 2U);
}

TEST(HeardLog, IsBounded) {
  const Logger speaker("tests");
  HeardLog log;
  for (std::size_t i = 0; i < HeardLog::kKept + 20; ++i) speaker.warning(std::to_string(i));
  speaker.warning(std::string(1'000'000, 'x'));
  std::vector<HeardLog::Entry> heard;
  const auto watch = log.watch([&](const HeardLog::Entry& entry) { heard.push_back(entry); });
  ASSERT_EQ(heard.size(), HeardLog::kKept);
  EXPECT_EQ(heard.front().message, "21");
  EXPECT_EQ(heard.back().message.size(), HeardLog::kLongest);
}

}  // namespace
}  // namespace pongsim::web
