#include "shared/threads/scheduling.hh"

#include <sched.h>

namespace pongsim::shared {

namespace {

// Both policies know no priority but 0.
constexpr sched_param kNoPriority{};

}  // namespace

GivesWay::GivesWay()
    : hasChanged_(sched_getscheduler(0) == SCHED_OTHER && sched_setscheduler(0, SCHED_BATCH, &kNoPriority) == 0) {}

GivesWay::~GivesWay() {
  if (hasChanged_) sched_setscheduler(0, SCHED_OTHER, &kNoPriority);
}

}  // namespace pongsim::shared
