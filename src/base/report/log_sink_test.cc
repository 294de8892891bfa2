#include "base/report/log_sink.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace pongsim {
namespace {

class LogSinksTest : public testing::Test {
 protected:
  LogSinksTest() { setLogLevel(LogLevel::kNone); }
  ~LogSinksTest() override { setLogLevel(LogLevel::kWarning); }

  LogSink::Heard keep() {
    return [this](const LogRecord& record) {
      heard_.push_back(std::to_string(static_cast<int>(record.level)) + " " + std::string(record.speaker) + ": " +
                       std::string(record.message));
    };
  }

  const Logger log_{"diff-drive of robot"};
  std::vector<std::string> heard_;
};

TEST_F(LogSinksTest, HearsWhatItsOwnLevelLetsThroughWhateverStderrDoes) {
  const LogSink sink(LogLevel::kWarning, keep());
  log_.error("e");
  log_.warning("w");
  log_.info("i");
  log_.debug("d");
  EXPECT_EQ(heard_, (std::vector<std::string>{"1 diff-drive of robot: e", "2 diff-drive of robot: w"}));
}

TEST_F(LogSinksTest, HearsNothingBeforeAndAfterItsLife) {
  log_.error("before");
  { const LogSink sink(LogLevel::kError, keep()); }
  log_.error("after");
  EXPECT_TRUE(heard_.empty());
}

TEST_F(LogSinksTest, EachOfSeveralHasALevelOfItsOwn) {
  const LogSink sink(LogLevel::kError, keep());
  {
    const LogSink other(LogLevel::kDebug, keep());
    log_.info("i");
    log_.error("e");
  }
  log_.info("i");
  EXPECT_EQ(heard_.size(), 3);
}

TEST_F(LogSinksTest, WhatASinkSaysIsNotHeardAgain) {
  int times = 0;
  const LogSink sink(LogLevel::kDebug, [&](const LogRecord&) {
    ++times;
    log_.error("so I heard");
  });
  log_.error("e");
  log_.error("e");
  EXPECT_EQ(times, 2);
}

TEST_F(LogSinksTest, WhoSpeaksDoesNotFailForWhoListens) {
  const LogSink sink(LogLevel::kDebug, [](const LogRecord&) { throw std::runtime_error("no"); });
  const LogSink other(LogLevel::kDebug, keep());
  EXPECT_NO_THROW(log_.error("e"));
  EXPECT_NO_THROW(log_.error("e"));
  EXPECT_EQ(heard_.size(), 2);
}

TEST_F(LogSinksTest, ManyThreadsSpeakWhileSinksComeAndGo) {
  std::atomic<int> total = 0;
  std::vector<std::jthread> threads;
  const LogSink always(LogLevel::kInfo, [&](const LogRecord&) { ++total; });
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([this] {
      for (int j = 0; j < 1000; ++j) log_.info("i");
    });
  }
  for (int i = 0; i < 200; ++i) {
    std::atomic<bool> isAlive = true;
    {
      const LogSink sink(LogLevel::kInfo, [&](const LogRecord&) { EXPECT_TRUE(isAlive); });
    }
    isAlive = false;
  }
  threads.clear();
  EXPECT_EQ(total, 4000);
}

}  // namespace
}  // namespace pongsim
