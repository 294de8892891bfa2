#include "shared/threads/scheduling.hh"

#include <sched.h>

namespace pongsim::shared {

namespace {

// The only priority that these policies allow.
constexpr sched_param kNoPriority{};

}  // namespace

BatchScheduling::BatchScheduling()
    : hasChanged_(sched_getscheduler(0) == SCHED_OTHER && sched_setscheduler(0, SCHED_BATCH, &kNoPriority) == 0) {}

BatchScheduling::~BatchScheduling() {
  if (hasChanged_) sched_setscheduler(0, SCHED_OTHER, &kNoPriority);
}

}  // namespace pongsim::shared
