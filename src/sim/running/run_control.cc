#include "sim/running/run_control.hh"

namespace pongsim::sim {

Outcome<void> RunControl::apply(const msgs::WorldControl& asked, Time now) {
  if (asked.reset == msgs::Reset::kTimeOnly || asked.reset == msgs::Reset::kModelsOnly) {
    return {"only the whole world can be reset: reset {all: true}"};
  }
  if (asked.seed != 0 && asked.reset != msgs::Reset::kAll) {
    return {"a new seed needs a reset: reset {all: true}"};
  }
  const bool startsAmongSteps = asked.reset == msgs::Reset::kAll && !asked.pause && stepsLeft_ > 0;
  paused_ = asked.pause || startsAmongSteps;
  if (startsAmongSteps) {
    --stepsLeft_;
  } else {
    stepsLeft_ = asked.pause ? asked.steps : 0;
  }
  runTo_ = !asked.pause && asked.runTo && *asked.runTo > now ? asked.runTo : std::nullopt;
  return {};
}

void RunControl::stepped(Time now) {
  if (stepsLeft_ > 0) --stepsLeft_;
  if (!runTo_ || now < *runTo_) return;
  paused_ = true;
  stepsLeft_ = 0;
  runTo_.reset();
}

}  // namespace pongsim::sim
