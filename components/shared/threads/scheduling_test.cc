#include "shared/threads/scheduling.hh"

#include <gtest/gtest.h>
#include <sched.h>

#include <thread>

namespace pongsim::shared {

namespace {

/// Runs it in a thread of its own of that policy, which needs no privilege.
template <class Body>
void inThreadOf(int policy, Body body) {
  std::thread([&] {
    const sched_param unused{};
    ASSERT_EQ(sched_setscheduler(0, policy, &unused), 0);
    body();
  }).join();
}

}  // namespace

TEST(BatchScheduling, ForAWhileAndInThreadsStartedMeanwhileForGood) {
  inThreadOf(SCHED_OTHER, [] {
    std::thread child;
    {
      const BatchScheduling scheduling;
      EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH);
      child = std::thread([] { EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH); });
    }
    EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
    child.join();
  });
}

TEST(BatchScheduling, LeavesAPolicyThatWasChosen) {
  inThreadOf(SCHED_IDLE, [] {
    {
      const BatchScheduling scheduling;
      EXPECT_EQ(sched_getscheduler(0), SCHED_IDLE);
    }
    EXPECT_EQ(sched_getscheduler(0), SCHED_IDLE);
  });
}

}  // namespace pongsim::shared
