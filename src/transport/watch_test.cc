#include "transport/watch.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>

#include "support/wait_until.hh"

namespace pongsim::transport {

namespace {

TEST(Watch, LooksAgainWhenItIsTold) {
  std::atomic<int> looks = 0;
  const Watch watch([&] {
    ++looks;
    return std::chrono::steady_clock::now() + std::chrono::milliseconds(1);
  });
  EXPECT_TRUE(test::waitUntil([&] { return looks >= 3; }));
}

TEST(Watch, EndsWithoutWaiting) {
  std::atomic<bool> hasLooked = false;
  const Watch watch([&] {
    hasLooked = true;
    return std::chrono::steady_clock::now() + std::chrono::hours(1);
  });
  EXPECT_TRUE(test::waitUntil([&] { return hasLooked.load(); }));
}

TEST(Watch, LooksAgainInASecondWhereMemoryWasShort) {
  std::atomic<int> looks = 0;
  const auto start = std::chrono::steady_clock::now();
  const Watch watch([&]() -> Watch::TimePoint {
    ++looks;
    throw std::bad_alloc();
  });
  EXPECT_TRUE(test::waitUntil([&] { return looks >= 2; }));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace

}  // namespace pongsim::transport
