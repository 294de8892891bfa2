#include "shared/threads/workers.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "support/thread_limit.hh"

namespace pongsim::shared {
namespace {

TEST(Workers, DoAllOnceWhoeverDoesIt) {
  // those that go to sleep at once, and those that spin
  for (const auto& [threads, spins] : {std::pair(1, 0), std::pair(2, 0), std::pair(5, 0), std::pair(2, 2000)}) {
    Workers workers(threads, spins);
    EXPECT_EQ(workers.count(), threads);
    for (std::size_t round = 0; round < 2000; ++round) {
      std::vector<int> done(round % 50);
      workers.forEach(done.size(), [&](std::size_t i, int) { ++done[i]; });
      ASSERT_EQ(std::ranges::count(done, 1), static_cast<std::ptrdiff_t>(done.size())) << threads << " " << round;
    }
  }
}

TEST(Workers, GiveNoTwoCallsAtOnceTheSameNumber) {
  Workers workers(4);
  std::vector<std::atomic<int>> at(4);
  std::atomic<int> clashes = 0;
  for (int round = 0; round < 200; ++round) {
    workers.forEach(100, [&](std::size_t, int worker) {
      if (at[static_cast<std::size_t>(worker)]++ != 0) ++clashes;
      --at[static_cast<std::size_t>(worker)];
    });
  }
  EXPECT_EQ(clashes, 0);
}

TEST(Workers, HelpOthersFromTheFarEndsOfTheirParts) {
  constexpr std::size_t kCount = 100;
  Workers workers(2);
  std::atomic<bool> hasBegun = false;
  std::atomic<std::size_t> done = 0;
  std::vector<std::size_t> order;
  workers.forEach(kCount, [&](std::size_t i, int worker) {
    if (worker == 0 && i == 0) {
      // its first piece of work takes until the other worker has done all else
      hasBegun = true;
      while (done != kCount - 1) std::this_thread::yield();
    } else {
      while (!hasBegun) std::this_thread::yield();
      if (worker == 1) order.push_back(i);
      ++done;
    }
  });
  ASSERT_EQ(order.size(), kCount - 1);
  for (std::size_t i = 0; i < kCount / 2; ++i) EXPECT_EQ(order[i], kCount / 2 + i);
  for (std::size_t i = kCount / 2; i < kCount - 1; ++i) EXPECT_EQ(order[i], kCount - 1 - i);
}

TEST(Workers, SeeWhatWasWrittenBefore) {
  Workers workers(3);
  std::vector<int> values(1000, 0);
  for (int round = 1; round <= 300; ++round) {
    workers.forEach(values.size(), [&](std::size_t i, int) { ++values[i]; });
    ASSERT_EQ(std::ranges::count(values, round), 1000);
  }
}

TEST(Workers, AreRefusedWhereTheSystemHasNoMoreThreads) {
  const test::ThreadLimit limit(2);
  try {
    const Workers workers(5);
    FAIL() << "started";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "can't start 5 threads: Resource temporarily unavailable");
  }
}

}  // namespace
}  // namespace pongsim::shared
