#include "shared/program/stop_signal.hh"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace pongsim::cli {
namespace {

TEST(StopSignal, IsAWishToEnd) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto hear = [signal] {
      takeStopSignals();
      if (isStopped()) std::exit(1);
      std::raise(signal);
      std::exit(isStopped() ? 0 : 2);
    };
    EXPECT_EXIT(hear(), testing::ExitedWithCode(0), "") << signal;
  }
}

TEST(StopSignal, EndsTheProcessTheSecondTime) {
  const auto hear = [] {
    takeStopSignals();
    std::raise(SIGINT);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(hear(), testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace pongsim::cli
