#pragma once

namespace pongsim::shared {

/// While it exists, the calling thread, and permanently the threads that it starts meanwhile, do not preempt running
/// threads when they wake (SCHED_BATCH, sched(7)), so that the simulation's thread is not delayed by those that carry
/// its messages. A scheduling policy chosen by the user is kept.
class BatchScheduling {
 public:
  BatchScheduling();
  ~BatchScheduling();
  BatchScheduling(const BatchScheduling&) = delete;
  BatchScheduling& operator=(const BatchScheduling&) = delete;

 private:
  bool hasChanged_;
};

}  // namespace pongsim::shared
