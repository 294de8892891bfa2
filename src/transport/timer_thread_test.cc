#include "transport/timer_thread.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>

#include "support/wait_until.hh"

namespace pongsim::transport {

namespace {

TEST(TimerThread, CallsAgainAtTheReturnedTime) {
  std::atomic<int> calls = 0;
  const TimerThread thread([&] {
    ++calls;
    return std::chrono::steady_clock::now() + std::chrono::milliseconds(1);
  });
  EXPECT_TRUE(test::waitUntil([&] { return calls >= 3; }));
}

TEST(TimerThread, EndsWithoutWaitingForTheNextCall) {
  std::atomic<bool> isCalled = false;
  const TimerThread thread([&] {
    isCalled = true;
    return std::chrono::steady_clock::now() + std::chrono::hours(1);
  });
  EXPECT_TRUE(test::waitUntil([&] { return isCalled.load(); }));
}

TEST(TimerThread, CallsAgainInASecondAfterBadAlloc) {
  std::atomic<int> calls = 0;
  const auto start = std::chrono::steady_clock::now();
  const TimerThread thread([&]() -> TimerThread::TimePoint {
    ++calls;
    throw std::bad_alloc();
  });
  EXPECT_TRUE(test::waitUntil([&] { return calls >= 2; }));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace

}  // namespace pongsim::transport
