#include "transport/watch.hh"

#include <gtest/gtest.h>

#include <new>
#include <semaphore>

#include "support/process.hh"

namespace pongsim::transport {

namespace {

TEST(Watch, LooksAgainWhenItIsTold) {
  std::counting_semaphore<> looks(0);
  const Watch watch([&] {
    looks.release();
    return std::chrono::steady_clock::now() + std::chrono::milliseconds(1);
  });
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(looks.try_acquire_for(test::kDeadline));
}

TEST(Watch, EndsWithoutWaiting) {
  std::binary_semaphore hasLooked(0);
  const Watch watch([&] {
    hasLooked.release();
    return std::chrono::steady_clock::now() + std::chrono::hours(1);
  });
  EXPECT_TRUE(hasLooked.try_acquire_for(test::kDeadline));
}

TEST(Watch, LooksAgainWhereMemoryWasShort) {
  std::counting_semaphore<> looks(0);
  const Watch watch([&]() -> Watch::TimePoint {
    looks.release();
    throw std::bad_alloc();
  });
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(looks.try_acquire_for(test::kDeadline));
}

}  // namespace

}  // namespace pongsim::transport
